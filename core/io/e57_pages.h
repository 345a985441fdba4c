// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "core/io/read_scan.h"

namespace relievo {

/// An E57 file as its sections see it: without the checksum that ends every page. Places in the
/// file are "physical" with the checksums counted, "logical" without.
class E57Pages {
 public:
  /// Reads the header and checks every page. @throw FileError  cut, damaged, another version
  explicit E57Pages(const ReadJob& job);

  /// @throw FileError  outside the file, or within a checksum
  std::uint64_t logicalFromPhysical(std::uint64_t physical) const;

  /// Appends `count` bytes from `logical` to `out`. @throw FileError  beyond the end
  void read(std::uint64_t logical, std::uint64_t count, std::string& out) const;

  std::uint64_t logicalBytes() const noexcept { return logical_bytes_; }

  std::string xml() const;  ///< @throw FileError

 private:
  void readHeader();
  void checkPages() const;

  const ReadJob& job_;
  std::uint64_t page_bytes_ = 0, payload_bytes_ = 0;
  std::uint64_t logical_bytes_ = 0;
  std::uint64_t xml_at_ = 0, xml_bytes_ = 0;  ///< Physical place, logical length.
};

}  // namespace relievo
