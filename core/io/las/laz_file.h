// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/io/las/las_header.h"
#include "core/io/las/laz_chunk.h"

namespace relievo {

/// Points that are packed together and can be unpacked without any others.
struct LazChunk {
  std::uint64_t at = 0;     ///< First byte in the file.
  std::uint64_t bytes = 0;  ///< Up to the end of the file, where all points are one chunk.
  std::uint64_t first = 0;  ///< Number of its first point.
  std::uint64_t points = 0;
  int level = -1;  ///< COPC: 0 is the coarsest; -1: another file.
};

/// What a LAZ or COPC file says of its points, checked: the chunks hold as many points as the
/// header promises, or fewer of a cut file, one after the other, and lie within the file.
struct LazFile {
  LazLayout layout;
  std::vector<LazChunk> chunks;
  std::uint64_t points = 0;  ///< Of all chunks.
  bool has_list = true;      ///< False: the list of chunks is cut off, they were found without it.
  bool is_copc = false;
  bool has_sizes = true;  ///< False: how many bytes its one chunk has is not stated.
};

/// Bytes of a file, wherever they are. @param read  `bytes` from `at` on, all of them
struct LazBytesSource {
  std::uint64_t size = 0;
  std::function<std::string(std::uint64_t at, std::uint64_t bytes)> read;
};

/// Reads all but the points; where the list of chunks is missing, which is the last thing in a
/// file, those before the cut. [any thread]
/// @throw FileError  no LAZ, a kind of packing that is not read here, or contradictions
LazFile readLazFile(const LazBytesSource& source, const LasHeader& header,
                    const std::filesystem::path& file);

/// Contents of the variable length record of this owner and number, if the file holds one.
/// @param head  the file up to its points
std::optional<std::string_view> lasRecord(std::string_view head, const LasHeader& header,
                                          std::string_view owner, std::uint16_t number);

/// Gives the chunks of a COPC file their levels. @param root  contents of its record copc/1
/// @throw FileError  the hierarchy is damaged: outside the file, in a circle, or of other chunks
void readCopcLevels(const LazBytesSource& source, std::string_view root, LazFile& laz,
                    const std::filesystem::path& file);

/// "Cannot read NAME: its 3rd block of points ..., where <damage>". @throw FileError
[[noreturn]] void refuseLazChunk(const std::filesystem::path& file, std::size_t chunk,
                                 const LazDamage& damage);

}  // namespace relievo
