// SPDX-License-Identifier: BSD-3-Clause
#include "core/io/export/export_grid.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>
#include <string_view>
#include <utility>

#include "core/base/error.h"
#include "core/base/failure.h"
#include "core/file/output_set.h"
#include "core/io/export/export_file.h"
#include "core/io/formats/unit_text.h"
#include "core/io/raster/raster_file.h"

namespace relievo {
namespace {

constexpr std::string_view kNoHeight = "-9999";  ///< Of ESRI ASCII grids.

void check(const ExportGrid& grid) {
  const std::size_t count = grid.size.count();
  if (grid.size.cols < 2 || grid.size.rows < 2 || grid.heights.size() != count ||
      grid.origins.size() != count || (!grid.colours.empty() && grid.colours.size() != count)) {
    throw failure<MessageId::export_of_no_map>(grid.size.cols, grid.size.rows);
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (grid.holds(i)) return;
  }
  throw failure<MessageId::export_without_heights>();
}

}  // namespace

ExportGrid viewGrid(const DepthMap& map) {
  return {.size = map.frame.size,
          .spacing = map.frame.spacing_mm,
          .first_x = map.frame.first_x_mm,
          .first_y = map.frame.first_y_mm,
          .heights = map.heights_mm,
          .origins = map.origins,
          .unit = "mm",
          .projection = {},
          .is_view = true};
}

namespace {

/// Holes lie on the base plane for the hand; a file's coordinates know no such plane.
void leaveOutBasePlane(ExportGrid& grid) {
  const auto cells = std::count(grid.origins.begin(), grid.origins.end(), CellStatus::base_plane);
  if (cells == 0) return;
  std::replace(grid.origins.begin(), grid.origins.end(), CellStatus::base_plane,
               CellStatus::outside);
  grid.left_out.push_back(
      std::to_string(cells) +
      (cells == 1 ? " cell without a height stays" : " cells without a height stay") +
      " empty: the base plane they rest on is none of the file's. Fill them "
      "with --holes membrane:MM2 if they are to have one.");
}

}  // namespace

std::optional<ExportGrid> fileGrid(const DepthMap& map, const ViewFromFile& view_from_file,
                                   LengthUnit unit, const RasterMap* raster) {
  const auto& m = view_from_file.m;
  const double scale = m[0];
  const bool from_top = scale > 0 && m[1] == 0 && m[2] == 0 && m[4] == 0 && m[6] == 0 &&
                        m[8] == 0 && m[9] == 0 && m[5] == scale && m[10] == scale;
  if (!from_top) return std::nullopt;
  ExportGrid grid = viewGrid(map);
  grid.is_view = false;
  grid.unit = name(unit);
  grid.spacing /= scale;
  grid.first_x = (map.frame.first_x_mm - m[3]) / scale;
  grid.first_y = (map.frame.first_y_mm - m[7]) / scale;
  for (float& height : grid.heights) {
    height = static_cast<float>((static_cast<double>(height) - m[11]) / scale);
  }
  leaveOutBasePlane(grid);
  if (raster == nullptr || raster->is_own_map) return grid;
  if (raster->projection.empty() || raster->info.unit == unit) {
    grid.projection = raster->projection;
  } else {
    grid.left_out.push_back("The raster's reference system was left out: it is not in " +
                            grid.unit + ".");
  }
  const auto near = [&](double a, double b) { return std::abs(a - b) < 1e-3 * raster->pixel; };
  if (raster->size != grid.size || !near(raster->first.x, grid.first_x) ||
      !near(raster->first.y, grid.first_y)) {
    return grid;  // A part of it, or another level.
  }
  grid.spacing = raster->pixel;
  grid.first_x = raster->first.x;
  grid.first_y = raster->first.y;
  for (std::size_t i = 0; i < grid.heights.size(); ++i) {
    if (grid.origins[i] == CellStatus::measured && raster->valid[i]) {
      grid.heights[i] = raster->values[i];
    }
  }
  return grid;
}

void stateSystem(ExportGrid& grid, const std::string& stated, LengthUnit unit) {
  if (stated.empty()) return;
  const std::string left_out = "The scan's reference system was left out: ";
  auto system = statedSystem(stated);
  if (!system) {
    grid.left_out.push_back(left_out + "it is not known here.");
  } else if (system->facts.is_geographic || unitOfMetres(system->facts.metres) != unit) {
    grid.left_out.push_back(left_out + "it is not in " + grid.unit + ".");
  } else {
    grid.projection = std::move(system->text);
    if (system->left_heights) {
      grid.left_out.emplace_back(
          "The reference system of the heights was left out: they are in another unit.");
    }
  }
}

std::optional<ExportFormat> exportFormatOf(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](char c) {
    return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  });
  constexpr std::array<std::pair<std::string_view, ExportFormat>, 8> kEndings{{
      {".tif", ExportFormat::geotiff},
      {".tiff", ExportFormat::geotiff},
      {".asc", ExportFormat::ascii_grid},
      {".vti", ExportFormat::vti},
      {".ply", ExportFormat::ply},
      {".xyz", ExportFormat::xyz},
      {".stl", ExportFormat::stl},
      {".glb", ExportFormat::gltf},
  }};
  for (const auto& [known, format] : kEndings) {
    if (known == ending) return format;
  }
  return std::nullopt;
}

void writeAsciiGrid(const std::filesystem::path& file, const ExportGrid& grid) {
  OutputSet set;  // A grid must not lie where another one's reference system says.
  ExportFile out(set.file(file));
  out << "ncols " << std::to_string(grid.size.cols) << "\nnrows " << std::to_string(grid.size.rows)
      << "\nxllcenter ";
  out.number(grid.first_x);
  out << "\nyllcenter ";
  out.number(grid.first_y);
  out << "\ncellsize ";
  out.number(grid.spacing);
  out << "\nNODATA_value " << kNoHeight << "\n";
  for (int row = grid.size.rows; row-- > 0;) {
    for (int col = 0; col < grid.size.cols; ++col) {
      const std::size_t i = grid.size.index({col, row});
      if (col > 0) out << " ";
      if (!grid.holds(i)) {
        out << kNoHeight;
        continue;
      }
      // A fraction in the first cell is what makes GDAL take the cells for real numbers.
      const float height = grid.heights[i];
      out.number(height);
      if (height == std::floor(height) && std::abs(height) < 1e6F) out << ".0";
    }
    out << "\n";
  }
  if (!grid.projection.empty()) {
    ExportFile projection(set.file(std::filesystem::path(file).replace_extension(".prj")));
    projection << grid.projection << "\n";
    projection.commit();
  }
  out.commit();
  set.commit();
}

void writeVti(const std::filesystem::path& file, const ExportGrid& grid) {
  const std::string extent = "0 " + std::to_string(grid.size.cols - 1) + " 0 " +
                             std::to_string(grid.size.rows - 1) + " 0 0";
  std::vector<float> heights = grid.heights;
  for (std::size_t i = 0; i < heights.size(); ++i) {
    if (!grid.holds(i)) heights[i] = std::nanf("");
  }
  const std::uint64_t height_bytes = heights.size() * sizeof(float);
  ExportFile out(file);
  out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"ImageData\" version=\"1.0\" "
         "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<ImageData WholeExtent=\""
      << extent << "\" Origin=\"";
  out.number(grid.first_x);
  out << " ";
  out.number(grid.first_y);
  out << " 0\" Spacing=\"";
  out.number(grid.spacing);
  out << " ";
  out.number(grid.spacing);
  out << " 1\">\n<Piece Extent=\"" << extent
      << "\">\n<PointData Scalars=\"height\">\n<DataArray type=\"Float32\" Name=\"height\" "
         "format=\"appended\" offset=\"0\"/>\n<DataArray type=\"UInt8\" Name=\"origin\" "
         "format=\"appended\" offset=\""
      << std::to_string(sizeof(std::uint64_t) + height_bytes)
      << "\"/>\n</PointData>\n</Piece>\n</ImageData>\n<AppendedData encoding=\"raw\">\n_";
  out.bytes(height_bytes);
  out.array(heights);
  out.bytes(static_cast<std::uint64_t>(grid.origins.size()));
  out.array(grid.origins);
  out << "\n</AppendedData>\n</VTKFile>\n";
  out.commit();
}

namespace {

/// Do floats tell the samples' places apart to a thousandth of their distance?
bool fitsFloats(const ExportGrid& grid) {
  const double farthest =
      std::max({std::abs(grid.first_x), std::abs(grid.first_y),
                std::abs(xOf(grid, grid.size.cols - 1)), std::abs(yOf(grid, grid.size.rows - 1))});
  return farthest * std::numeric_limits<float>::epsilon() <= 1e-3 * grid.spacing;
}

template <class Real>
void writePlyVertices(ExportFile& out, const ExportGrid& grid) {
  for (int row = 0; row < grid.size.rows; ++row) {
    for (int col = 0; col < grid.size.cols; ++col) {
      const std::size_t i = grid.size.index({col, row});
      if (!grid.holds(i)) continue;
      out.bytes(static_cast<Real>(xOf(grid, col)));
      out.bytes(static_cast<Real>(yOf(grid, row)));
      out.bytes(static_cast<Real>(grid.heights[i]));
      out.bytes(static_cast<std::uint8_t>(grid.origins[i]));
      if (!grid.colours.empty()) out.bytes(grid.colours[i]);
    }
  }
}

}  // namespace

void writePlyMesh(const std::filesystem::path& file, const ExportGrid& grid) {
  std::uint32_t count = 0;
  const std::vector<std::int32_t> numbers = vertexNumbers(grid, count);
  const std::vector<Triangle> triangles = trianglesBetween(grid, numbers);
  const bool as_floats = fitsFloats(grid);
  const std::string real = as_floats ? "float" : "double";
  const std::string colours = grid.colours.empty() ? ""
                                                   : "property uchar red\nproperty uchar green\n"
                                                     "property uchar blue\nproperty uchar alpha\n";
  ExportFile out(file);
  out << "ply\nformat binary_little_endian 1.0\ncomment unit " << grid.unit << "\nelement vertex "
      << std::to_string(count) << "\nproperty " << real << " x\nproperty " << real
      << " y\nproperty " << real << " z\nproperty uchar origin\n"
      << colours << "element face " << std::to_string(triangles.size())
      << "\nproperty list uchar int vertex_indices\nend_header\n";
  if (as_floats) {
    writePlyVertices<float>(out, grid);
  } else {
    writePlyVertices<double>(out, grid);
  }
  for (const Triangle& triangle : triangles) {
    out.bytes(std::uint8_t{3});
    out.bytes(triangle);
  }
  out.commit();
}

void writeXyz(const std::filesystem::path& file, const ExportGrid& grid) {
  ExportFile out(file);
  for (int row = 0; row < grid.size.rows; ++row) {
    for (int col = 0; col < grid.size.cols; ++col) {
      const std::size_t i = grid.size.index({col, row});
      if (!grid.holds(i)) continue;
      out.number(xOf(grid, col));
      out << " ";
      out.number(yOf(grid, row));
      out << " ";
      out.number(grid.heights[i]);
      out << "\n";
    }
  }
  out.commit();
}

namespace {

using Corner = std::array<float, 3>;

/// A plate: the map above, walls, and a fan of triangles below. Every edge of it belongs to two
/// triangles that run along it in opposite directions.
class StlPlate {
 public:
  StlPlate(const ExportGrid& grid, double plate) : grid_(grid) {
    double lowest = 0;  // Where there is no height the plate is at 0.
    for (std::size_t i = 0; i < grid.heights.size(); ++i) {
      if (grid.holds(i)) lowest = std::min(lowest, static_cast<double>(grid.heights[i]));
    }
    bottom_ = static_cast<float>(lowest - plate);
  }

  std::uint32_t triangles() const noexcept {
    const auto cols = static_cast<std::uint32_t>(grid_.size.cols - 1);
    const auto rows = static_cast<std::uint32_t>(grid_.size.rows - 1);
    return 2 * cols * rows + 3 * 2 * (cols + rows);
  }

  void write(ExportFile& out) const {
    for (int row = 0; row + 1 < grid_.size.rows; ++row) {
      for (int col = 0; col + 1 < grid_.size.cols; ++col) {
        triangle(out, top(col, row), top(col + 1, row), top(col + 1, row + 1));
        triangle(out, top(col, row), top(col + 1, row + 1), top(col, row + 1));
      }
    }
    const int last_col = grid_.size.cols - 1;
    const int last_row = grid_.size.rows - 1;
    for (int col = 0; col < last_col; ++col) {
      rim(out, {col, 0}, {col + 1, 0});
      rim(out, {col + 1, last_row}, {col, last_row});
    }
    for (int row = 0; row < last_row; ++row) {
      rim(out, {last_col, row}, {last_col, row + 1});
      rim(out, {0, row + 1}, {0, row});
    }
  }

 private:
  Corner top(int col, int row) const {
    const std::size_t i = grid_.size.index({col, row});
    return {static_cast<float>(col * grid_.spacing), static_cast<float>(row * grid_.spacing),
            grid_.holds(i) ? grid_.heights[i] : 0.0F};
  }
  Corner below(Cell cell) const {
    Corner corner = top(cell.col, cell.row);
    corner[2] = bottom_;
    return corner;
  }

  /// The wall below one step along the rim, counterclockwise seen from above, and the bottom.
  void rim(ExportFile& out, Cell from, Cell to) const {
    const Corner high_from = top(from.col, from.row);
    const Corner high_to = top(to.col, to.row);
    triangle(out, high_from, below(from), below(to));
    triangle(out, high_from, below(to), high_to);
    const Corner centre{static_cast<float>(0.5 * (grid_.size.cols - 1) * grid_.spacing),
                        static_cast<float>(0.5 * (grid_.size.rows - 1) * grid_.spacing), bottom_};
    triangle(out, below(to), below(from), centre);
  }

  static void triangle(ExportFile& out, const Corner& a, const Corner& b, const Corner& c) {
    std::array<float, 3> u{};
    std::array<float, 3> v{};
    for (std::size_t i = 0; i < 3; ++i) {
      u[i] = b[i] - a[i];
      v[i] = c[i] - a[i];
    }
    std::array<float, 3> normal{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                                u[0] * v[1] - u[1] * v[0]};
    const float length =
        std::sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
    for (float& n : normal) n = length > 0 ? n / length : 0;
    out.bytes(normal);
    for (const Corner& corner : {a, b, c}) out.bytes(corner);
    out.bytes(std::uint16_t{0});
  }

  const ExportGrid& grid_;
  float bottom_ = 0;
};

}  // namespace

void writeStlPlate(const std::filesystem::path& file, const ExportGrid& grid, double plate) {
  if (!(plate > 0) || !std::isfinite(plate)) {
    throw failure<MessageId::export_plate_too_thin>();
  }
  const double most =
      2.0 * grid.size.cols * grid.size.rows + 6.0 * (grid.size.cols + grid.size.rows);
  if (most > 4e9) {
    throw failure<MessageId::export_stl_too_large>();
  }
  const StlPlate solid(grid, plate);
  ExportFile out(file);
  std::string title = "relief plate in " + grid.unit;
  title.resize(80, ' ');
  out << title;
  out.bytes(solid.triangles());
  solid.write(out);
  out.commit();
}

double estimatedBytes(GridSize size, ExportFormat format, bool has_colours) {
  const auto cells = static_cast<double>(size.count());
  const double colour = has_colours ? 4 : 0;
  switch (format) {
    case ExportFormat::geotiff:
      return 3 * cells;
    case ExportFormat::cloud_geotiff:
      return 4 * cells;  // A third more for overviews.
    case ExportFormat::ascii_grid:
      return 9 * cells;
    case ExportFormat::vti:
      return 5 * cells;
    case ExportFormat::ply:
      return (13 + colour + 2 * 13) * cells;
    case ExportFormat::xyz:
      return 27 * cells;
    case ExportFormat::stl:
      return 2 * 50 * cells;
    case ExportFormat::gltf:
      return (24 + 2 * colour + 24) * cells;
  }
  return 0;
}

void exportGrid(const std::filesystem::path& file, const ExportGrid& grid, ExportFormat format,
                const ExportOptions& options, const Task& task) {
  check(grid);
  task.check();
  switch (format) {
    case ExportFormat::geotiff:
      return writeGeoTiff(file, grid);
    case ExportFormat::cloud_geotiff:
      return writeCloudGeoTiff(file, grid, task);
    case ExportFormat::gltf:
      return writeGltf(file, grid, task);
    case ExportFormat::ascii_grid:
      return writeAsciiGrid(file, grid);
    case ExportFormat::vti:
      return writeVti(file, grid);
    case ExportFormat::ply:
      return writePlyMesh(file, grid);
    case ExportFormat::xyz:
      return writeXyz(file, grid);
    case ExportFormat::stl:
      return writeStlPlate(file, grid, options.plate_mm);
  }
}

}  // namespace relievo
