// SPDX-License-Identifier: BSD-3-Clause
// Layout: ASTM E2807, file header and pages.
#include "core/io/e57/e57_pages.h"

#include <algorithm>

#include "core/base/failure.h"
#include "core/io/e57/crc32c.h"
#include "core/io/file_check.h"
#include "core/io/formats/scalar.h"

namespace relievo {
namespace {

constexpr std::size_t kHeaderBytes = 48;
constexpr std::size_t kChecksumBytes = 4;
constexpr std::uint64_t kMaxXmlBytes = 64U << 20U;
constexpr std::uint64_t kPagesPerLook = 4096;  ///< At the stop token.

}  // namespace

E57Pages::E57Pages(const ReadJob& job) : job_(job) {
  readHeader();
  checked_.resize(static_cast<std::size_t>(logical_bytes_ / payload_bytes_));
  checkPage(0);
}

void E57Pages::readHeader() {
  const std::string_view bytes = job_.bytes;
  if (bytes.size() < kHeaderBytes) {
    throw failure<MessageId::shorter_than_e57_header>(shownName(job_.file));
  }
  const auto u64_at = [bytes](std::size_t at) {
    return loadAs<std::uint64_t>(bytes.data() + at, ByteOrder::little);
  };
  const auto major = loadAs<std::uint32_t>(bytes.data() + 8, ByteOrder::little);
  if (major != 1) {
    throwReadError(job_.file, said<MessageId::refused_e57_version>(major));
  }
  const std::uint64_t promised = u64_at(16);
  xml_at_ = u64_at(24);
  xml_bytes_ = u64_at(32);
  page_bytes_ = u64_at(40);
  // The standard knows pages of 1024 bytes only; other powers of two are harmless.
  if (page_bytes_ < 64 || page_bytes_ > (1U << 20U) || (page_bytes_ & (page_bytes_ - 1)) != 0) {
    throwReadError(job_.file, said<MessageId::refused_e57_page_size>(),
                   said<MessageId::advice_copy_or_export>());
  }
  // The list of scans is at the end, so nothing of a cut file can be placed.
  if (promised > bytes.size()) {
    const ImportOptions strict;
    ScanInfo none;
    handleTruncation({RecordKind::bytes, promised, bytes.size(), 0},
                     {job_.file, job_.bytes, strict, job_.task}, none);
  }
  if (promised < page_bytes_ || promised % page_bytes_ != 0) {
    throwReadError(job_.file, said<MessageId::refused_e57_length>(),
                   said<MessageId::advice_copy_or_export>());
  }
  payload_bytes_ = page_bytes_ - kChecksumBytes;
  logical_bytes_ = promised / page_bytes_ * payload_bytes_;
}

void E57Pages::checkPage(std::uint64_t page) {
  if (checked_[page]) return;
  const std::string_view bytes = job_.bytes.substr(page * page_bytes_, page_bytes_);
  const auto stored = loadAs<std::uint32_t>(bytes.data() + payload_bytes_, ByteOrder::big);
  if (crc32c(bytes.substr(0, payload_bytes_)) != stored) {
    throw E57Fault(said<MessageId::e57_wrong_checksum>(page + 1, checked_.size()));
  }
  checked_[page] = true;
}

void E57Pages::check(std::uint64_t from, std::uint64_t to) {
  const std::uint64_t first = from / payload_bytes_;
  const std::uint64_t end = (to + payload_bytes_ - 1) / payload_bytes_;
  for (std::uint64_t page = first; page < end; ++page) {
    if ((page - first) % kPagesPerLook == 0) {
      job_.task.check();
      job_.task.report("checking pages",
                       static_cast<double>(page) / static_cast<double>(checked_.size()));
    }
    checkPage(page);
  }
}

std::uint64_t E57Pages::logicalFromPhysical(std::uint64_t physical) const {
  const std::uint64_t within = physical % page_bytes_;
  const std::uint64_t logical = physical / page_bytes_ * payload_bytes_ + within;
  if (within >= payload_bytes_ || logical >= logical_bytes_) {
    throw E57Fault(said<MessageId::e57_place_outside>());
  }
  return logical;
}

void E57Pages::read(std::uint64_t logical, std::uint64_t count, std::string& out) {
  if (logical > logical_bytes_ || count > logical_bytes_ - logical) {
    throw E57Fault(said<MessageId::e57_part_outside>());
  }
  while (count > 0) {
    const std::uint64_t page = logical / payload_bytes_;
    const std::uint64_t within = logical % payload_bytes_;
    const std::uint64_t here = std::min(count, payload_bytes_ - within);
    checkPage(page);
    out += job_.bytes.substr(page * page_bytes_ + within, here);
    logical += here;
    count -= here;
  }
}

std::string E57Pages::xml() {
  if (xml_bytes_ == 0 || xml_bytes_ > kMaxXmlBytes) {
    throw E57Fault(said<MessageId::e57_list_length>());
  }
  std::string text;
  read(logicalFromPhysical(xml_at_), xml_bytes_, text);
  return text;
}

}  // namespace relievo
