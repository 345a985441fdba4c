// SPDX-License-Identifier: BSD-3-Clause
// Mutations of E57 files that keep their form: the XML may become longer or shorter, and header,
// pages and checksums (by the target) follow. Without this nearly every change of the XML's length
// made a file that ends in its middle, and the width of a number, a logarithm of two decimal
// numbers there, was never another than a seed's.
#include <algorithm>
#include <cstring>
#include <optional>
#include <string>

#include "core/io/formats/scalar.h"
#include "tests/core/io/sample_files.h"
#include "tests/fuzz/mutation.h"

namespace relievo::fuzz {
namespace {

constexpr std::size_t kPage = 1024;
constexpr std::size_t kPayload = 1020;
constexpr std::size_t kHeader = 48;

/// A file without its checksums, and its XML apart; what followed it is gone.
struct Parts {
  std::string binary;  ///< Header and sections.
  std::string xml;
};

std::optional<Parts> partsOf(const std::string& file) {
  Parts parts;
  for (std::size_t at = 0; at + kPage <= file.size(); at += kPage) {
    parts.binary += file.substr(at, kPayload);
  }
  if (parts.binary.empty()) return std::nullopt;
  const auto physical = loadAs<std::uint64_t>(parts.binary.data() + 24, ByteOrder::little);
  const auto length = loadAs<std::uint64_t>(parts.binary.data() + 32, ByteOrder::little);
  if (physical >= file.size()) return std::nullopt;
  const std::size_t at = physical / kPage * kPayload + std::min(physical % kPage, kPayload);
  if (at < kHeader || at >= parts.binary.size() || length > parts.binary.size() - at) {
    return std::nullopt;
  }
  parts.xml = parts.binary.substr(at, length);
  parts.binary.resize(at);
  return parts;
}

std::string fileOf(const Parts& parts) {
  std::string logical = parts.binary + parts.xml;
  const std::size_t pages = (logical.size() + kPayload - 1) / kPayload;
  logical.resize(pages * kPayload, '\0');
  logical.replace(16, 8, test::bytesOf(static_cast<std::uint64_t>(pages * kPage)));
  logical.replace(32, 8, test::bytesOf(static_cast<std::uint64_t>(parts.xml.size())));
  std::string file;
  for (std::size_t page = 0; page < pages; ++page) {
    file += logical.substr(page * kPayload, kPayload) + std::string(kPage - kPayload, '\0');
  }
  return file;
}

/// Sections and packets: their places are known from elsewhere, so they keep their length.
void mutateSections(std::string& binary, Chance& chance) {
  const std::size_t bytes = binary.size() - kHeader;
  if (bytes < 2) return;
  if (chance.oneIn(2)) {  // Lengths of packets and of the streams' shares are of 16 bits.
    const std::size_t at = kHeader + chance.below(bytes / 2) * 2;
    binary.replace(at, 2, test::bytesOf(static_cast<std::uint16_t>(chance.number())));
    return;
  }
  std::string part = binary.substr(kHeader);
  mutateBytes(part, 0);
  part.resize(bytes, '\0');
  binary.replace(kHeader, bytes, part);
}

bool mutateForm(Parts& parts, Chance& chance) {
  switch (chance.below(8)) {
    case 0:
    case 1:
    case 2:
      return changeNumber(parts.xml, chance);
    case 3:
      return moveElement(parts.xml, '<', "/>", chance);
    case 4:
    case 5:
      mutateBytes(parts.xml, 64);
      return true;
    default:
      mutateSections(parts.binary, chance);
      return true;
  }
}

}  // namespace
}  // namespace relievo::fuzz

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t max_size, unsigned seed) {
  using namespace relievo::fuzz;
  Chance chance(seed);
  std::optional<Parts> parts;
  if (!chance.oneIn(8)) parts = partsOf({reinterpret_cast<const char*>(data), size});
  if (!parts || !mutateForm(*parts, chance)) return LLVMFuzzerMutate(data, size, max_size);
  return handBack(fileOf(*parts), data, size, max_size);
}
