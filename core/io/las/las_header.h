// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "core/cloud/scan.h"

namespace relievo {

/// What the public header of a LAS 1.0 to 1.4 file says about its points.
struct LasHeader {
  int minor = 0;         ///< Version 1.minor.
  int point_format = 0;  ///< 0 to 10; all start with x, y, z as 32-bit whole numbers.
  bool packed = false;   ///< LAZ or COPC.
  std::size_t header_bytes = 0;
  std::uint64_t points_at = 0;  ///< Byte of the first record; may lie beyond a cut file.
  std::size_t record_bytes = 0;
  std::uint32_t variable_records = 0;
  std::uint64_t points = 0;
  std::array<double, 3> scale{}, offset{};
  std::optional<FileBounds> stated_bounds;  ///< Nothing if the numbers make no box.
};

/// @param bytes  the file, or at least its first 375 bytes
/// @throw FileError  too short, another version, or numbers that cannot be
LasHeader parseLasHeader(std::string_view bytes, const std::filesystem::path& file);

}  // namespace relievo
