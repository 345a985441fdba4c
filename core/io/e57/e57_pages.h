// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/io/read_scan.h"
#include "core/message/message.h"

namespace relievo {

/// What is wrong with a part of an E57 file: "a packet makes no sense." One scan's fault leaves the
/// others readable.
struct E57Fault : std::runtime_error {
  explicit E57Fault(Message of_catalogue)
      : std::runtime_error(englishText(of_catalogue)), why(std::move(of_catalogue)) {}
  Message why;
};

/// An E57 file as its sections see it: without the checksum that ends every page. Places in the
/// file are "physical" with the checksums counted, "logical" without. Every page's checksum is
/// looked at before a byte of it is used. [owner]
class E57Pages {
 public:
  /// Reads the header. @throw FileError  cut, another version. E57Fault  its page is damaged
  explicit E57Pages(const ReadJob& job);

  /// @throw E57Fault  outside the file, or within a checksum
  std::uint64_t logicalFromPhysical(std::uint64_t physical) const;

  /// Appends `count` bytes from `logical` to `out`. @throw E57Fault  beyond the end, or damaged
  void read(std::uint64_t logical, std::uint64_t count, std::string& out);

  /// Looks at all pages of logical bytes `from` ... `to` - 1, which are within the file.
  /// @throw E57Fault  one is damaged; Cancelled
  void check(std::uint64_t from, std::uint64_t to);

  std::uint64_t logicalBytes() const noexcept { return logical_bytes_; }

  std::string xml();  ///< @throw E57Fault

 private:
  void readHeader();
  void checkPage(std::uint64_t page);

  const ReadJob& job_;
  std::vector<bool> checked_;  ///< By page.
  std::uint64_t page_bytes_ = 0, payload_bytes_ = 0;
  std::uint64_t logical_bytes_ = 0;
  std::uint64_t xml_at_ = 0, xml_bytes_ = 0;  ///< Physical place, logical length.
};

}  // namespace relievo
