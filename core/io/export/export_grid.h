// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/grid.h"
#include "core/base/task.h"
#include "core/base/transform.h"
#include "core/base/unit.h"
#include "core/depth/depth_map.h"
#include "core/io/raster/raster.h"

namespace relievo {

/// A depth map on its way to other programs: heights on a square grid, in one unit and one frame.
struct ExportGrid {
  GridSize size;
  double spacing = 1, first_x = 0, first_y = 0;  ///< Of the samples, in `unit`.
  std::vector<float> heights;                    ///< Row-major, row 0 at the lowest y; in `unit`.
  std::vector<CellStatus> origins;               ///< Same order and size.
  std::string unit = "mm";
  std::string projection;  ///< Well-known text, in `unit`; empty: none stated.
  std::string state = {};  ///< As MapFileOptions::state, of a GeoTIFF.
  bool is_view = false;    ///< View mm above the base plane, not a file's coordinates.
  /// sRGB and alpha of every cell, as many as heights, or none. Meshes (PLY, glTF) show them.
  std::vector<std::array<std::uint8_t, 4>> colours = {};
  std::vector<std::string> left_out = {};  ///< For people: what the file had and this has not.

  /// Is there a height? Holes on the base plane have one, cells outside the object have none.
  bool holds(std::size_t i) const noexcept { return origins[i] != CellStatus::outside; }
};

/// As the map is: view millimetres above the base plane.
ExportGrid viewGrid(const DepthMap& map);

/// In the coordinates and the unit of the file that the map was made from. Nothing unless it was
/// seen from the top, as elevation models are: only then is a height a z of the file. Cells on the
/// base plane have no height there: nobody measured one. A reference system that does not agree
/// with the unit is left out.
/// @param raster  if it was made from one: gives place, projection, and measured heights to the bit
std::optional<ExportGrid> fileGrid(const DepthMap& map, const ViewFromFile& view_from_file,
                                   LengthUnit unit, const RasterMap* raster = nullptr);

/// States the system that a file of points does, if it is in the grid's unit; else says why not.
/// @param stated  ScanInfo::reference_system; empty: nothing is done
void stateSystem(ExportGrid& grid, const std::string& stated, LengthUnit unit);

enum class ExportFormat { geotiff, cloud_geotiff, ascii_grid, vti, ply, xyz, stl, gltf };

/// By the name's ending: .tif .tiff .asc .vti .ply .xyz .stl .glb
std::optional<ExportFormat> exportFormatOf(const std::filesystem::path& file);

struct ExportOptions {
  double plate_mm =
      3;  ///< STL: thickness of the plate below the lowest height, in the grid's unit.
};

/// Writes under a temporary name and renames. GeoTIFF: float32, a mask band within, NaN where
/// there is no height. ESRI ASCII: shortest digits, -9999, projection in NAME.prj. VTI: float32
/// `height` and uint8 `origin` as raw appended data. PLY: binary, x, y and z all float, or all
/// double where floats do not tell the places apart, triangles between four neighbours with
/// heights. XYZ: text. STL: a plate for printing, closed on all sides, that rises to the map; where
/// there is no height it is at 0, x and y from the first sample. [worker]
/// @throw WriteError; Cancelled; ArgumentError  fewer than 2 x 2 samples, no height, or no plate
void exportGrid(const std::filesystem::path& file, const ExportGrid& grid, ExportFormat format,
                const ExportOptions& options = {}, const Task& task = {});

/// About how many bytes the file will have; compressed ones from what such maps usually take.
double estimatedBytes(GridSize size, ExportFormat format, bool has_colours = false);

// One function per format.
void writeGeoTiff(const std::filesystem::path& file, const ExportGrid& grid);
/// Compressed tiles with overviews inside, in the order in which a web server can serve them part
/// by part (GDAL's driver COG). @throw WriteError, Cancelled
void writeCloudGeoTiff(const std::filesystem::path& file, const ExportGrid& grid, const Task& task);
/// glTF 2.0 as one binary file: a mesh in metres about the map's middle, its normals, and colours
/// if the grid has any (in linear light, as the format wants them). A map in view millimetres
/// stands upright and faces the viewer; one in a file's coordinates lies, north away from the
/// viewer. The middle's own coordinates are in `extras`. docs/adr/0099.
/// @throw WriteError; ArgumentError  more than 4 GB, which the format cannot hold
void writeGltf(const std::filesystem::path& file, const ExportGrid& grid, const Task& task);
void writeAsciiGrid(const std::filesystem::path& file, const ExportGrid& grid);
void writeVti(const std::filesystem::path& file, const ExportGrid& grid);
void writePlyMesh(const std::filesystem::path& file, const ExportGrid& grid);
void writeXyz(const std::filesystem::path& file, const ExportGrid& grid);
void writeStlPlate(const std::filesystem::path& file, const ExportGrid& grid, double plate);

}  // namespace relievo
