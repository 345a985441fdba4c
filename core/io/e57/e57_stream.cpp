// SPDX-License-Identifier: BSD-3-Clause
// Sections, packets and packed bits: ASTM E2807, section on binary sections.
#include "core/io/e57/e57_stream.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include "core/io/formats/little_endian.h"
#include "core/io/worker/planted_fault.h"
#include "core/message/catalogue.h"

namespace relievo {
namespace {

constexpr std::uint64_t kSectionHead = 32;
constexpr std::uint64_t kPacketHead = 4;  ///< Kind, flags, length - 1.
constexpr std::uint64_t kDataHead = 6;    ///< The same and the number of streams.
constexpr char kVectorSection = 1;
constexpr char kIndexPacket = 0, kDataPacket = 1, kEmptyPacket = 2;

[[noreturn]] void refusePacket() {
  throw E57Fault(said<MessageId::e57_packet>());
}

/// A packet with points: what comes before the streams' shares, and where these begin.
struct DataPacket {
  std::string head;
  std::uint64_t shares_at = 0;  ///< Logical.

  std::uint64_t share(std::size_t stream) const { return u16At(head, kDataHead + 2 * stream); }
};

/// Finds the next data packet from `at` on and moves `at` behind it.
/// @return  false at the end of the section. @throw E57Fault
bool nextPacket(const E57Section& section, E57Pages& pages, std::uint64_t& at, DataPacket& packet) {
  while (at + kPacketHead <= section.end) {
    packet.head.clear();
    pages.read(at, kPacketHead, packet.head);
    const char kind = packet.head[0];
    const std::uint64_t length = std::uint64_t{u16At(packet.head, 2)} + 1;
    if (length % 4 != 0 || length > section.end - at) refusePacket();
    const std::uint64_t start = at;
    at += length;
    if (kind == kIndexPacket || kind == kEmptyPacket) continue;
    const std::uint64_t head = kDataHead + 2 * section.streams;
    if (kind != kDataPacket || length < head) refusePacket();
    pages.read(start + kPacketHead, head - kPacketHead, packet.head);
    if (u16At(packet.head, kPacketHead) != section.streams) refusePacket();
    std::uint64_t shares = 0;
    for (std::size_t i = 0; i < section.streams; ++i) shares += packet.share(i);
    if (shares > length - head) refusePacket();
    packet.shares_at = start + head;
    return true;
  }
  return false;
}

}  // namespace

E57Section openE57Section(const E57Scan& scan, E57Pages& pages) {
  const std::uint64_t start = pages.logicalFromPhysical(scan.section_at);
  std::string head;
  pages.read(start, kSectionHead, head);
  const auto length = loadAs<std::uint64_t>(head.data() + 8, ByteOrder::little);
  const auto data_at = loadAs<std::uint64_t>(head.data() + 16, ByteOrder::little);
  E57Section section;
  section.first_packet = pages.logicalFromPhysical(data_at);
  section.end = start + length;
  section.streams = scan.fields.size();
  if (head[0] != kVectorSection || section.end < start || section.end > pages.logicalBytes() ||
      section.first_packet < start + kSectionHead || section.first_packet > section.end) {
    throw E57Fault(said<MessageId::e57_section>());
  }
  pages.check(start, section.end);
  std::uint64_t at = section.first_packet;
  DataPacket packet;
  while (nextPacket(section, pages, at, packet)) {
  }
  return section;
}

/// Appends this stream's share of the next data packet. @return  false at the end of the section
bool E57Stream::loadPacket() {
  bytes_.erase(0, bit_ / 8);
  bit_ %= 8;
  DataPacket packet;
  if (!nextPacket(section_, pages_, packet_, packet)) return false;
  plantedFault(field_.bits == 13 && !bytes_.empty());
  std::uint64_t at = packet.shares_at;
  for (std::size_t i = 0; i < stream_; ++i) at += packet.share(i);
  pages_.read(at, packet.share(stream_), bytes_);
  return true;
}

/// The next number's bits, lowest first; they may start anywhere in a byte.
std::uint64_t E57Stream::takeBits() {
  const std::size_t first = bit_ / 8;
  const unsigned shift = bit_ % 8;
  std::array<char, 9> here{};
  std::memcpy(here.data(), bytes_.data() + first, std::min(here.size(), bytes_.size() - first));
  std::uint64_t bits = loadAs<std::uint64_t>(here.data(), ByteOrder::little) >> shift;
  if (shift != 0) bits |= std::uint64_t{static_cast<unsigned char>(here[8])} << (64 - shift);
  bit_ += field_.bits;
  return field_.bits == 64 ? bits : bits & ((std::uint64_t{1} << field_.bits) - 1);
}

std::optional<double> E57Stream::next() {
  while (8 * bytes_.size() - bit_ < field_.bits) {
    if (!loadPacket()) return std::nullopt;
  }
  const std::uint64_t bits = field_.bits == 0 ? 0 : takeBits();
  switch (field_.kind) {
    case E57Field::Kind::f32:
      return static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)));
    case E57Field::Kind::f64:
      return std::bit_cast<double>(bits);
    default:
      break;
  }
  const auto whole = static_cast<std::int64_t>(static_cast<std::uint64_t>(field_.minimum) + bits);
  return static_cast<double>(whole) * field_.scale + field_.offset;
}

}  // namespace relievo
