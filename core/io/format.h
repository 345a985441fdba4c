// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace relievo {

/// What a file is, by its content first and its name second.
enum class FileFormat {
  ply,
  pcd,
  obj,
  stl,
  text,
  tiff,
  png,
  ascii_grid,
  las,
  laz,
  e57,
  three_ds,
  ptx,
  other_raster,
  other,  ///< Known not to be a scan (picture, archive, web page ...).
};

struct FoundFormat {
  FileFormat format = FileFormat::other;
  std::string name;  ///< For messages, with its article: "a LAS file".
};

/// @param head  the first bytes, at least 64 kB or the whole file
FoundFormat findFormat(std::string_view head, const std::filesystem::path& file,
                       std::uint64_t file_size);

/// What names of scans and rasters end in, for lists of files to open: "ply", "las". Each once.
std::vector<std::string_view> offeredEndings();

/// The scans that are read, as people call them: "PLY, PCD, OBJ". Whatever names the formats takes
/// them from here, so that another reader is named everywhere.
std::string scanFormatList(std::string_view separator = ", ");

/// Read by readRaster: TIFF, PNG, ESRI ASCII grid.
bool isReadableRaster(FileFormat format) noexcept;

/// GDAL's name of a kind of raster, and ours. For any other format those of GeoTIFF.
struct RasterKind {
  const char* driver;
  std::string_view name;
};
RasterKind rasterKindOf(FileFormat format) noexcept;

/// Throws unless this version reads the format as a scan. @throw FileError
void checkReadableAsScan(const FoundFormat& found, const std::filesystem::path& file);

inline constexpr std::size_t kSniffedBytes = 65536;

}  // namespace relievo
