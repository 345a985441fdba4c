// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "core/base/task.h"
#include "core/io/export/export_grid.h"
#include "core/region/region.h"
#include "core/session/surface.h"

namespace relievo {

/// Which part of a surface goes to another program.
enum class ExportPart {
  map,     ///< All of it, at its finest level.
  level,   ///< All of it, at a chosen level of the pyramid.
  window,  ///< The 200 x 200 samples of a region, as they lie under the hand.
};

/// What is written for other programs; one record for window and command line.
struct MapExport {
  ExportFormat format = ExportFormat::geotiff;
  ExportPart part = ExportPart::map;
  Region region = {};          ///< Its level for `level`; all of it for `window`.
  bool in_file_frame = false;  ///< The file's coordinates and unit, not view mm.
  double plate_mm = 3;         ///< As ExportOptions.
  std::string state = {};      ///< As MapFileOptions::state.
};

/// What was written.
struct ExportedMap {
  GridSize size;
  double spacing = 1, first_x = 0, first_y = 0;  ///< In `unit`.
  std::string unit;
  std::size_t heights = 0;            ///< Cells that have one.
  std::vector<std::string> left_out;  ///< As ExportGrid::left_out.
};

/// Cells of what is chosen, for an estimate before the work. @throw ArgumentError  no such level
GridSize exportedSize(const Surface& surface, const MapExport& choice);

/// The chosen part as a grid. [worker]
/// @param raster  what the surface was made from, if it was a raster; else null
/// @throw ArgumentError  not seen from the top, which in_file_frame needs; no such level, or (E102)
///                       a map by tiles that is larger than memory; FileError
ExportGrid exportedGrid(const Surface& surface, const MapExport& choice, const RasterMap* raster);

/// Writes the chosen part: the same bytes from the window and from the command line. The whole map
/// as GeoTIFF in view mm is a MAP that relievo opens again as it is. [worker]
/// @throw as exportedGrid and exportGrid
ExportedMap exportMap(const std::filesystem::path& file, const Surface& surface,
                      const MapExport& choice, const RasterMap* raster, const Task& task = {});

/// Facts of a grid for a report.
ExportedMap reportOf(const ExportGrid& grid);

}  // namespace relievo
