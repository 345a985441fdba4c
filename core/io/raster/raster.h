// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/base/task.h"
#include "core/base/transform.h"
#include "core/cloud/scan.h"
#include "core/depth/colours/colours.h"
#include "core/depth/depth_map.h"
#include "core/file/atomic_file.h"

namespace relievo {

/// What is known of a height raster without its cells: either a foreign raster (heights in the
/// file's unit) or a MAP written by this program (heights in view mm, origins and view known).
struct RasterHead {
  ScanInfo info;  ///< points = cells; bounds from the georeference and the heights.
  GridSize size;
  double pixel = 1;         ///< Sample distance, file unit; x and y agree to 1e-6.
  FilePoint first;          ///< File position of sample (0, 0), z = 0.
  bool is_placed = true;    ///< The file says where its samples lie; else `pixel` is 1.
  bool is_own_map = false;  ///< Written by writeMap.
  std::optional<ViewFromFile> view_from_file;  ///< Of an own map.
  std::string projection;  ///< Well-known text, true of these heights; empty if none is stated.
  std::string set;         ///< MapFileOptions::set of an own map; empty: none is stated.
};

/// A height raster in memory.
struct RasterMap : RasterHead {
  std::vector<float> values;  ///< Row-major, row 0 at the lowest y (files have it at the top).
  std::vector<bool> valid;    ///< Not nodata and finite.
  std::vector<CellStatus> origins;  ///< Of an own map with its origin file beside it; else empty.
  GridColours colours;  ///< Likewise; of importRaster only (core/io/raster/colour_raster.h).
};

/// Takes a raster row by row, in the order of its file.
struct RasterSink {
  /// Once, before the rows: all but what the heights tell.
  std::function<void(const RasterHead& head, bool has_origins)> begin;
  /// Row 0 has the lowest y. NaN: no height. `origins` is null if there are none (any more).
  std::function<void(int row, const float* heights, const CellStatus* origins)> row;
};

struct RasterEnd {
  RasterHead head;
  bool has_origins = false;  ///< False: also those that were given are to be left aside.
};

/// Reads band 1 of a GeoTIFF, TIFF, PNG or ESRI ASCII grid through GDAL, a row at a time. [worker]
/// @throw FileError  unreadable, rotated or non-square pixels, or no valid cell; Cancelled
RasterEnd readRasterRows(const std::filesystem::path& file, const RasterSink& sink,
                         const Task& task);

/// The same into memory. [worker] @throw as readRasterRows
RasterMap readRaster(const std::filesystem::path& file);

inline constexpr const char* kPointsUnit = "points";  ///< MapFileOptions::unit of counts.

struct MapFileOptions {
  ViewFromFile view_from_file;
  bool write_origins = true;  ///< Also NAME.origin.tif.
  bool mask_band = false;     ///< Also a mask within the file: 255 where there is a height, else 0.
  bool outside_as_nan = true;  ///< False: outside cells keep their height, 0.
  std::string state = {};      ///< ASCII; becomes the image description. Empty: none.
  std::string unit = "mm";     ///< Of the values. Others than mm are not read back as a map.
  std::string set = {};        ///< Which files belong together, as setOf; empty: of this map alone.
  std::string what = {};       ///< Of values that belong to another map's cells; empty: a map.
  std::optional<int> level = {};  ///< Of a pyramid.
};

/// What the files that are written together all say: a checksum of heights, origins, frame, colours
/// and state, so that the same command writes the same bytes again.
std::string setOf(const DepthMap& map, const GridColours& colours, const MapFileOptions& options);

/// MapFileOptions::set of files written with it, and of all files of a tiled map.
inline constexpr const char* kSetFact = "RELIEVO_MAP_CONTENT";
/// MapFileOptions::what, and what files beside a map hold.
inline constexpr const char* kContentFact = "RELIEVO_CONTENT";
inline constexpr const char* kLevelFact = "RELIEVO_LEVEL";  ///< MapFileOptions::level.

/// Writes MAP.tif (float32, mm, NaN outside, north-up geotransform in view mm whose cell centres
/// are the samples, RELIEVO_* metadata) and MAP.origin.tif (uint8 codes). Both are written before
/// one takes its place, so that a failure leaves nothing half done.
/// @throw WriteError
void writeMap(const OutputFile& file, const DepthMap& map, const MapFileOptions& options);

/// The `state` that a TIFF was written with: its image description. Nothing if it has none.
/// [worker]
/// @throw FileError  not a readable TIFF
std::optional<std::string> rasterState(const std::filesystem::path& file);

}  // namespace relievo
