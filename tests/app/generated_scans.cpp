// SPDX-License-Identifier: BSD-3-Clause
#include "tests/app/generated_scans.h"

#include <gdal_priv.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <memory>
#include <random>
#include <sstream>
#include <vector>

#include "tests/core/io/e57_sample.h"
#include "tests/core/io/las_sample.h"
#include "tests/core/io/laz_sample.h"
#include "tests/core/io/sample_files.h"

namespace relievo::test {
namespace {

using Point = std::array<double, 3>;
using Points = std::vector<Point>;

constexpr std::array kShapes{"dome",         "plane",        "tilted plane", "wall",
                             "line along x", "line along z", "skew line",    "one spot",
                             "box",          "ball",         "two heaps",    "with holes of NaN"};

Point placeOf(const std::string& shape, std::mt19937& random) {
  // Not std::uniform_real_distribution: its numbers differ between libraries.
  const auto share = [&random] { return static_cast<double>(random()) / 4294967296.0; };
  const double u = share(), v = share(), w = share();
  if (shape == "dome") return {u, v, 0.3 * (1 - (u - 0.5) * (u - 0.5) - (v - 0.5) * (v - 0.5))};
  if (shape == "plane") return {u, v, 0};
  if (shape == "tilted plane") return {u, v, 0.7 * u - 0.2 * v};
  if (shape == "wall") return {0, u, v};
  if (shape == "line along x") return {u, 0, 0};
  if (shape == "line along z") return {0, 0, u};
  if (shape == "skew line") return {u, 0.5 * u, 0.25 * u};
  if (shape == "one spot") return {0.5, 0.5, 0.5};
  if (shape == "box") return {u, v, w};
  if (shape == "two heaps") return {u * 1e-3 + (w < 0.5 ? 0 : 1), v * 1e-3, w * 1e-3};
  if (shape == "with holes of NaN" && w < 0.3) {
    const double none = std::numeric_limits<double>::quiet_NaN();
    return {none, none, none};
  }
  constexpr double kTurn = 6.283185307179586;
  const double height = 2 * v - 1, radius = std::sqrt(1 - height * height);
  return {radius * std::cos(kTurn * u), radius * std::sin(kTurn * u), height};
}

std::string number(double value) {
  std::ostringstream text;
  text.precision(17);
  text << value;
  return text.str();
}

std::string rows(const Points& points, const char* separator, const std::string& rest = {}) {
  std::string text;
  for (const Point& p : points) {
    text += number(p[0]) + separator + number(p[1]) + separator + number(p[2]) + rest + '\n';
  }
  return text;
}

template <class T>
std::string binary(const Points& points, bool big_endian = false) {
  std::string bytes;
  for (const Point& p : points) {
    for (const double value : p) bytes += bytesOf(static_cast<T>(value), big_endian);
  }
  return bytes;
}

std::string count(const Points& points) {
  return std::to_string(points.size());
}

std::string pcd(const Points& points, const std::string& data) {
  PcdWords words;
  words.data = data;
  words.points = count(points);
  if (data == "ascii") return pcdHeader(words) + rows(points, " ");
  if (data == "binary") return pcdHeader(words) + binary<float>(points);
  std::string columns, packed;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const Point& p : points) columns += bytesOf(static_cast<float>(p[axis]));
  }
  for (std::size_t at = 0; at < columns.size(); at += 30) {  // LZF literals.
    const std::string part = columns.substr(at, 30);
    packed += static_cast<char>(part.size() - 1) + part;
  }
  return pcdHeader(words) + bytesOf(static_cast<std::uint32_t>(packed.size())) +
         bytesOf(static_cast<std::uint32_t>(columns.size())) + packed;
}

std::string obj(const Points& points, bool faces) {
  std::string text;
  for (const Point& p : points) {
    text += "v " + number(p[0]) + ' ' + number(p[1]) + ' ' + number(p[2]) + '\n';
  }
  for (std::size_t i = 3; faces && i <= points.size(); i += 3) {
    text +=
        "f " + std::to_string(i - 2) + ' ' + std::to_string(i - 1) + ' ' + std::to_string(i) + '\n';
  }
  return text;
}

std::string stl(const Points& points, bool text) {
  const std::size_t triangles = points.size() / 3;
  std::string bytes =
      text ? "solid s\n" : std::string(80, ' ') + bytesOf(static_cast<std::uint32_t>(triangles));
  for (std::size_t i = 0; i < triangles; ++i) {
    bytes += text ? "facet normal 0 0 1\nouter loop\n" : binary<float>({{0, 0, 1}});
    for (std::size_t k = 3 * i; k < 3 * i + 3; ++k) {
      bytes += text ? "vertex " + rows({points[k]}, " ") : binary<float>({points[k]});
    }
    bytes += text ? std::string("endloop\nendfacet\n") : std::string(2, '\0');
  }
  return text ? bytes + "endsolid s\n" : bytes;
}

std::string threeDs(const Points& all) {
  const auto chunk = [](std::uint16_t kind, const std::string& body) {
    return bytesOf(kind) + bytesOf(static_cast<std::uint32_t>(6 + body.size())) + body;
  };
  const auto kept = static_cast<std::uint16_t>(std::min<std::size_t>(all.size(), 65'000));
  const Points points(all.begin(), all.begin() + kept);
  std::string faces = bytesOf(static_cast<std::uint16_t>(kept / 3));
  for (std::uint16_t i = 2; i < kept; i = static_cast<std::uint16_t>(i + 3)) {
    for (const int back : {2, 1, 0}) faces += bytesOf(static_cast<std::uint16_t>(i - back));
    faces += bytesOf(std::uint16_t{0});
  }
  const std::string mesh =
      chunk(0x4110, bytesOf(kept) + binary<float>(points)) + chunk(0x4120, faces);
  return chunk(0x4D4D, chunk(0x3D3D, chunk(0x4000, std::string("a\0", 2) + chunk(0x4100, mesh))));
}

std::array<std::int32_t, 3> stored(const Point& p, const Point& offset, double scale) {
  std::array<std::int32_t, 3> raw{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double steps = std::round((p[axis] - offset[axis]) / scale);
    raw[axis] = std::abs(steps) < 2e9 ? static_cast<std::int32_t>(steps) : 0;
  }
  return raw;
}

/// LAS has whole numbers; NaN becomes the origin.
std::string las(const Points& points, double size, const Point& offset) {
  Las file;
  file.count = 0;
  file.legacy_promised = static_cast<std::uint32_t>(points.size());
  file.promised = points.size();
  file.scale.fill(size / 1e6);
  file.offset = offset;
  for (const Point& p : points) file.raw.push_back(stored(p, offset, size / 1e6));
  return lasFile(file);
}

std::string laz(const Points& points, double size) {
  Laz file;
  file.how.format = 1;
  file.scale = size / 1e6;
  for (const Point& p : points) {
    std::string record;
    for (const std::int32_t raw : stored(p, {0, 0, 0}, file.scale)) record += bytesOf(raw);
    record.resize(28, '\0');
    record[14] = 0x09;  // Return 1 of 1.
    file.records.push_back(record);
  }
  return lazFile(file).bytes;
}

std::string e57(const Points& points) {
  std::array<std::string, 3> columns;
  for (const Point& p : points) {
    for (std::size_t axis = 0; axis < 3; ++axis) columns[axis] += bytesOf(p[axis]);
  }
  const std::string real = R"(type="Float")";
  E57Sample sample;
  sample.add({count(points),
              {{"cartesianX", real, columns[0]},
               {"cartesianY", real, columns[1]},
               {"cartesianZ", real, columns[2]}},
              {},
              {},
              16'000});
  return sample.file();
}

std::string ptx(const Points& points) {
  return count(points) + "\n1\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n" +
         rows(points, " ", " 0.5");
}

/// The points' heights, as many in a row as in a column, or all of them in one row.
struct Heights {
  explicit Heights(const Points& points, double pixel_size) : pixel(pixel_size) {
    const auto side = static_cast<int>(std::sqrt(static_cast<double>(points.size())));
    cols = points.size() % 2 == 0 ? side
                                  : static_cast<int>(std::min<std::size_t>(points.size(), 2000));
    row_count = points.size() % 2 == 0 ? side : std::min(1, cols);
    for (int i = 0; i < cols * row_count; ++i) {
      values.push_back(points[static_cast<std::size_t>(i)][2]);
    }
  }
  int cols = 0, row_count = 0;
  double pixel;
  std::vector<double> values;
};

std::string grid(const Heights& heights) {
  std::string text = "ncols " + std::to_string(heights.cols) + "\nnrows " +
                     std::to_string(heights.row_count) + "\nxllcorner 0\nyllcorner 0\ncellsize " +
                     number(heights.pixel) + '\n';
  for (const double height : heights.values) text += number(height) + ' ';
  return text + '\n';
}

std::string raster(Heights heights, const char* driver, GDALDataType type) {
  if (heights.values.empty()) return {};
  GDALAllRegister();
  auto* const drivers = GetGDALDriverManager();
  const std::unique_ptr<GDALDataset> memory(drivers->GetDriverByName("MEM")->Create(
      "", heights.cols, heights.row_count, 1, type, nullptr));
  std::array<double, 6> place{0, heights.pixel, 0, 0, 0, -heights.pixel};
  memory->SetGeoTransform(place.data());
  if (memory->GetRasterBand(1)->RasterIO(GF_Write, 0, 0, heights.cols, heights.row_count,
                                         heights.values.data(), heights.cols, heights.row_count,
                                         GDT_Float64, 0, 0, nullptr) != CE_None) {
    return {};
  }
  GDALClose(drivers->GetDriverByName(driver)->CreateCopy("/vsimem/generated", memory.get(), 0,
                                                         nullptr, nullptr, nullptr));
  vsi_l_offset size = 0;
  const GByte* const bytes = VSIGetMemFileBuffer("/vsimem/generated", &size, FALSE);
  std::string file(reinterpret_cast<const char*>(bytes), static_cast<std::size_t>(size));
  VSIUnlink("/vsimem/generated");
  VSIUnlink("/vsimem/generated.aux.xml");
  return file;
}

std::string plyFaces(const Points& points) {
  std::string faces;
  for (std::size_t i = 2; i < points.size(); i += 3) {
    faces += '\3';
    for (const std::size_t back : {2U, 1U, 0U})
      faces += bytesOf(static_cast<std::int32_t>(i - back));
  }
  return plyHeader("binary_little_endian", count(points), "float",
                   "element face " + std::to_string(points.size() / 3) +
                       "\nproperty list uchar int vertex_indices\n") +
         binary<float>(points) + faces;
}

struct Made {
  const Points& points;
  double size;
  Point offset;
};

struct Format {
  const char* ending;
  std::string (*write)(const Made&);
};

const std::array kFormats{
    Format{".ply",
           [](const Made& m) {
             return plyHeader("ascii", count(m.points), "double") + rows(m.points, " ");
           }},
    Format{".ply", [](const Made& m) { return plyFaces(m.points); }},
    Format{".ply",
           [](const Made& m) {
             return plyHeader("binary_big_endian", count(m.points), "double") +
                    binary<double>(m.points, true);
           }},
    Format{".pcd", [](const Made& m) { return pcd(m.points, "ascii"); }},
    Format{".pcd", [](const Made& m) { return pcd(m.points, "binary"); }},
    Format{".pcd", [](const Made& m) { return pcd(m.points, "binary_compressed"); }},
    Format{".obj", [](const Made& m) { return obj(m.points, false); }},
    Format{".obj", [](const Made& m) { return obj(m.points, true); }},
    Format{".stl", [](const Made& m) { return stl(m.points, false); }},
    Format{".stl", [](const Made& m) { return stl(m.points, true); }},
    Format{".3ds", [](const Made& m) { return threeDs(m.points); }},
    Format{".las", [](const Made& m) { return las(m.points, m.size, m.offset); }},
    Format{".laz", [](const Made& m) { return laz(m.points, m.size); }},
    Format{".e57", [](const Made& m) { return e57(m.points); }},
    Format{".ptx", [](const Made& m) { return ptx(m.points); }},
    Format{".xyz", [](const Made& m) { return rows(m.points, " "); }},
    Format{".pts", [](const Made& m) { return count(m.points) + '\n' + rows(m.points, " "); }},
    Format{".csv", [](const Made& m) { return "x,y,z\n" + rows(m.points, ","); }},
    Format{".asc", [](const Made& m) { return grid(Heights(m.points, m.size / 100)); }},
    Format{".tif",
           [](const Made& m) {
             return raster(Heights(m.points, m.size / 100), "GTiff", GDT_Float32);
           }},
    Format{".png", [](const Made& m) { return raster(Heights(m.points, 1), "PNG", GDT_UInt16); }},
};

}  // namespace

GeneratedScan generatedScan(std::uint32_t seed, int number_of) {
  std::mt19937 random(seed * 1'000'003U + static_cast<std::uint32_t>(number_of));
  const auto oneOf = [&random](const auto& choices) {
    return choices[random() % std::size(choices)];
  };
  constexpr std::array<std::size_t, 20> kCounts{
      0,  1,   1,   2,    3,     4,      4,      5,       7,       9,
      30, 100, 500, 1000, 5'000, 20'000, 20'000, 100'000, 100'001, 1'000'000};
  constexpr std::array kSizes{1e-30, 1e-9,  1e-4,  0.01, 1.0, 1.0,
                              50.0,  300.0, 300.0, 1e5,  1e9, 1e30};
  constexpr std::array kOffsets{0.0, 0.0, 0.0, -7.5, 5.4e5, 1e12, -1e20};
  const std::string shape = oneOf(kShapes);
  const double size = oneOf(kSizes);
  const double away = oneOf(kOffsets);
  Points points(oneOf(kCounts));
  for (Point& p : points) {
    p = placeOf(shape, random);
    for (double& value : p) value = value * size + away;
  }
  const Format& format = kFormats[static_cast<std::size_t>(number_of) % kFormats.size()];
  return {"scan" + std::to_string(number_of) + format.ending,
          shape + ", " + count(points) + " points, size " + number(size) + ", at " + number(away),
          format.write({points, size, {away, away, away}})};
}

}  // namespace relievo::test
