// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/grid.h"
#include "core/base/transform.h"
#include "core/base/unit.h"
#include "core/depth/depth_map.h"
#include "core/io/raster.h"

namespace relievo {

/// A depth map on its way to other programs: heights on a square grid, in one unit and one frame.
struct ExportGrid {
  GridSize size;
  double spacing = 1, first_x = 0, first_y = 0;  ///< Of the samples, in `unit`.
  std::vector<float> heights;                    ///< Row-major, row 0 at the lowest y; in `unit`.
  std::vector<Origin> origins;                   ///< Same order and size.
  std::string unit = "mm";
  std::string projection;  ///< Well-known text; empty: none.
  std::string state = {};  ///< As MapFileOptions::state, of a GeoTIFF.
  /// Of the scan, empty or like `heights`; a PLY mesh carries them, with red, green and blue.
  std::vector<Rgba> colours = {};

  /// Is there a height? Holes on the base plane have one, cells outside the object have none.
  bool holds(std::size_t i) const noexcept { return origins[i] != Origin::outside; }
};

/// As the map is: view millimetres above the base plane.
ExportGrid viewGrid(const DepthMap& map);

/// In the coordinates and the unit of the file that the map was made from. Nothing unless it was
/// seen from the top, as elevation models are: only then is a height a z of the file.
/// @param raster  if it was made from one: gives place, projection, and measured heights to the bit
std::optional<ExportGrid> fileGrid(const DepthMap& map, const ViewFromFile& view_from_file,
                                   LengthUnit unit, const RasterMap* raster = nullptr);

enum class ExportFormat { geotiff, ascii_grid, vti, ply, xyz, stl };

/// By the name's ending: .tif .tiff .asc .vti .ply .xyz .stl
std::optional<ExportFormat> exportFormatOf(const std::filesystem::path& file);

struct ExportOptions {
  double plate_mm =
      3;  ///< STL: thickness of the plate below the lowest height, in the grid's unit.
};

/// Writes under a temporary name and renames. GeoTIFF: float32, a mask band within, NaN where
/// there is no height. ESRI ASCII: shortest digits, -9999, projection in NAME.prj. VTI: float32
/// `height` and uint8 `origin` as raw appended data. PLY: binary, double x and y, float z,
/// triangles between four neighbours with heights, the scan's colours if there are any (where a
/// sample has none: mid grey). XYZ: text. STL: a plate for printing, closed on
/// all sides, that rises to the map; where there is no height it is at 0, x and y from the first
/// sample. [worker]
/// @throw WriteError; ArgumentError  fewer than 2 x 2 samples, no height, or no plate
void exportGrid(const std::filesystem::path& file, const ExportGrid& grid, ExportFormat format,
                const ExportOptions& options = {});

// One function per format.
void writeGeoTiff(const std::filesystem::path& file, const ExportGrid& grid);
void writeAsciiGrid(const std::filesystem::path& file, const ExportGrid& grid);
void writeVti(const std::filesystem::path& file, const ExportGrid& grid);
void writePlyMesh(const std::filesystem::path& file, const ExportGrid& grid);
void writeXyz(const std::filesystem::path& file, const ExportGrid& grid);
void writeStlPlate(const std::filesystem::path& file, const ExportGrid& grid, double plate);

}  // namespace relievo
