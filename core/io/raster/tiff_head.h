// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/base/task.h"

namespace relievo {

/// What the first directory of a TIFF or BigTIFF says: enough to know our own files again and to
/// find their tiles.
struct TiffHead {
  std::uint64_t cols = 0, rows = 0;
  std::uint32_t bands = 1;
  std::uint32_t bits = 1;                      ///< Of one cell of one band.
  std::uint32_t sample_format = 1;             ///< 1: whole numbers, 3: floating point.
  std::uint32_t compression = 1;               ///< 1: none.
  std::uint32_t planes = 1;                    ///< 2: one band after the other.
  std::uint32_t tile_cols = 0, tile_rows = 0;  ///< 0: strips.
  bool little_endian = true;
  std::vector<std::uint64_t> tile_offsets;   ///< Band by band if planes is 2; of tiles only.
  std::map<std::string, std::string> facts;  ///< GDAL's entries; TIFFTAG_IMAGEDESCRIPTION.
};

/// Asks an import process: that a file says it is ours does not make it so. [any thread]
/// @return  nothing if the file is no TIFF, or its first directory is damaged.
/// @throw FileError  as checkedFileSize; Cancelled
std::optional<TiffHead> importTiffHead(const std::filesystem::path& file, const Task& task = {});
/// The same of several files by one process.
std::vector<std::optional<TiffHead>> importTiffHeads(
    const std::vector<std::filesystem::path>& files, const Task& task = {});

/// The same, read in this process without a library. [worker process]
std::optional<TiffHead> readTiffHead(const std::filesystem::path& file);

/// Its image description. Nothing if it has none. @throw FileError  there is no head
std::optional<std::string> descriptionIn(const std::optional<TiffHead>& head,
                                         const std::filesystem::path& file);

/// What is given to GDAL, in bytes. It compares every entry with all before it: the six million
/// that 180 MB hold would take it hours.
inline constexpr std::uint64_t kMostTiffMetadata = std::uint64_t{1} << 20U;

/// Bytes of the longest list of GDAL's own entries in any directory of a TIFF; 0 for other files.
/// [worker process]
/// @throw FileError  as checkedFileSize
std::uint64_t largestTiffMetadata(const std::filesystem::path& file);

/// Was the file written by this program, as a TIFF? False for all else. [any thread]
bool isOwnTiff(const std::filesystem::path& file);

/// To be asked before the work, of files that people did not name themselves but that lie beside
/// the one they named (levels, origins): what is not ours is never replaced. [any thread]
/// @throw WriteError  a file is there that this program did not write
void requireOwnOrAbsent(const std::filesystem::path& file);

}  // namespace relievo
