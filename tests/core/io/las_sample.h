// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "tests/core/io/sample_files.h"

namespace relievo::test {

inline constexpr std::array<int, 11> kLasRecordBytes{20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67};

/// In all bytes of a record that a test does not care for: a point of class 10 or 42, not withheld.
inline constexpr char kLasFill = 0x2A;

/// What goes into a LAS file; the defaults make a good one of ten points (i, i / 2, i / 4).
struct Las {
  int minor = 2;
  int format = 0;
  int count = 10;       ///< Records written.
  int extra_bytes = 0;  ///< Behind each record's own.
  std::uint64_t promised = 10;
  std::uint32_t legacy_promised = 10;
  std::array<double, 3> scale{0.25, 0.25, 0.25};
  std::array<double, 3> offset{0, 0, 0};
  std::vector<std::array<std::int32_t, 3>> raw;  ///< Instead of the ten points.
  std::vector<std::string> rest;  ///< First bytes of each record behind its coordinates.
  std::string variable_records;
  std::uint32_t variable_count = 0;
};

inline std::string lasFile(const Las& las) {
  const std::size_t header_bytes = las.minor == 4 ? 375 : las.minor == 3 ? 235 : 227;
  const auto record_bytes = static_cast<std::uint16_t>(
      kLasRecordBytes[static_cast<std::size_t>(las.format)] + las.extra_bytes);
  std::string bytes(header_bytes, '\0');
  const auto put = [&bytes](std::size_t at, const std::string& value) {
    bytes.replace(at, value.size(), value);
  };
  put(0, "LASF");
  put(24, std::string("\1") + static_cast<char>(las.minor));
  put(94, bytesOf(static_cast<std::uint16_t>(header_bytes)));
  put(96, bytesOf(static_cast<std::uint32_t>(header_bytes + las.variable_records.size())));
  put(100, bytesOf(las.variable_count));
  put(104, std::string(1, static_cast<char>(las.format)));
  put(105, bytesOf(record_bytes));
  put(107, bytesOf(las.legacy_promised));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    put(131 + 8 * axis, bytesOf(las.scale[axis]));
    put(155 + 8 * axis, bytesOf(las.offset[axis]));
  }
  if (las.minor == 4) put(247, bytesOf(las.promised));
  bytes += las.variable_records;
  const int count = las.raw.empty() ? las.count : static_cast<int>(las.raw.size());
  for (int i = 0; i < count; ++i) {
    const auto point = las.raw.empty() ? std::array<std::int32_t, 3>{4 * i, 2 * i, i}
                                       : las.raw[static_cast<std::size_t>(i)];
    for (const std::int32_t stored : point) bytes += bytesOf(stored);
    const std::string rest =
        las.rest.empty() ? std::string() : las.rest[static_cast<std::size_t>(i)];
    bytes += rest + std::string(record_bytes - 12U - rest.size(), kLasFill);
  }
  return bytes;
}

inline std::string variableRecord(std::uint16_t kind, const std::string& content) {
  std::string user = "LASF_Projection";
  user.resize(16, '\0');
  return bytesOf(std::uint16_t{0}) + user + bytesOf(kind) +
         bytesOf(static_cast<std::uint16_t>(content.size())) + std::string(32, '\0') + content;
}

inline std::string geoKeys(const std::vector<std::array<std::uint16_t, 4>>& keys) {
  std::string content;
  const auto add = [&content](const std::array<std::uint16_t, 4>& key) {
    for (const std::uint16_t part : key) content += bytesOf(part);
  };
  add({1, 1, 0, static_cast<std::uint16_t>(keys.size())});
  for (const auto& key : keys) add(key);
  return variableRecord(34735, content);
}

inline Las withRecord(const std::string& record) {
  Las las;
  las.variable_records = record;
  las.variable_count = 1;
  return las;
}

}  // namespace relievo::test
