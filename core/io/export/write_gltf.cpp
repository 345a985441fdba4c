// SPDX-License-Identifier: BSD-3-Clause
// Meshes for viewers on the web: glTF 2.0, binary form (Khronos, "glTF 2.0 Specification").
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/failure.h"
#include "core/base/unit.h"
#include "core/io/export/export_file.h"
#include "core/io/export/export_grid.h"
#include "core/io/formats/number_text.h"

namespace relievo {
namespace {

constexpr std::uint32_t kMagic = 0x46546C67;  // "glTF"
constexpr std::uint32_t kJson = 0x4E4F534A;
constexpr std::uint32_t kBinary = 0x004E4942;
constexpr std::size_t kRowsBetweenLooks = 64;

using Vector = std::array<float, 3>;

/// From the grid to glTF's axes: metres, y up, the front towards +z.
class Axes {
 public:
  explicit Axes(const ExportGrid& grid)
      : metres_(mmPer(lengthUnit(grid.unit).value_or(LengthUnit::mm)) / 1000),
        middle_{grid.first_x + 0.5 * (grid.size.cols - 1) * grid.spacing,
                grid.first_y + 0.5 * (grid.size.rows - 1) * grid.spacing, 0},
        lies_(!grid.is_view) {
    double lowest = std::numeric_limits<double>::infinity();
    double highest = -lowest;
    for (std::size_t i = 0; i < grid.heights.size(); ++i) {
      if (!grid.holds(i)) continue;
      lowest = std::min(lowest, static_cast<double>(grid.heights[i]));
      highest = std::max(highest, static_cast<double>(grid.heights[i]));
    }
    middle_[2] = 0.5 * (lowest + highest);
  }
  Vector place(double x, double y, double z) const {
    return turned({static_cast<float>((x - middle_[0]) * metres_),
                   static_cast<float>((y - middle_[1]) * metres_),
                   static_cast<float>((z - middle_[2]) * metres_)});
  }
  Vector turned(const Vector& v) const { return lies_ ? Vector{v[0], v[2], -v[1]} : v; }
  const std::array<double, 3>& middle() const noexcept { return middle_; }

 private:
  double metres_;
  std::array<double, 3> middle_;
  bool lies_;
};

/// Across the triangles around each vertex, each weighted by its area.
std::vector<Vector> normalsOf(const std::vector<Vector>& places,
                              const std::vector<Triangle>& triangles) {
  std::vector<Vector> normals(places.size(), Vector{});
  for (const Triangle& t : triangles) {
    const Vector& a = places[static_cast<std::size_t>(t[0])];
    const Vector& b = places[static_cast<std::size_t>(t[1])];
    const Vector& c = places[static_cast<std::size_t>(t[2])];
    const Vector u{b[0] - a[0], b[1] - a[1], b[2] - a[2]};
    const Vector v{c[0] - a[0], c[1] - a[1], c[2] - a[2]};
    const Vector n{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
    for (const std::int32_t corner : t) {
      for (std::size_t k = 0; k < 3; ++k) normals[static_cast<std::size_t>(corner)][k] += n[k];
    }
  }
  return normals;
}

void makeUnit(std::vector<Vector>& normals, const Vector& alone) {
  for (Vector& n : normals) {
    const double length = std::hypot(n[0], n[1], n[2]);
    if (!(length > 0)) {
      n = alone;  // Of a vertex without triangles.
      continue;
    }
    for (float& part : n) part = static_cast<float>(static_cast<double>(part) / length);
  }
}

/// 8 bits of sRGB to 16 bits of linear light (IEC 61966-2-1).
std::uint16_t linear(std::uint8_t stored) {
  const double s = stored / 255.0;
  const double light = s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
  return static_cast<std::uint16_t>(std::lround(65535 * light));
}

std::vector<std::array<std::uint16_t, 4>> coloursOf(const ExportGrid& grid) {
  std::array<std::uint16_t, 256> light{};
  for (std::size_t i = 0; i < light.size(); ++i) light[i] = linear(static_cast<std::uint8_t>(i));
  std::vector<std::array<std::uint16_t, 4>> colours;
  for (std::size_t i = 0; i < grid.colours.size(); ++i) {
    if (!grid.holds(i)) continue;
    const auto& c = grid.colours[i];
    // Opaque: alpha tells here where a colour comes from, not how much shows through.
    colours.push_back({light[c[0]], light[c[1]], light[c[2]], 65535});
  }
  return colours;
}

std::string triple(const Vector& v) {
  const std::string text = roundTripText(
      std::array{static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])});
  std::string list = "[";
  for (const char c : text) list += c == ' ' ? ',' : c;
  return list + "]";
}

std::string view(std::uint64_t at, std::uint64_t bytes, int target) {
  return R"({"buffer":0,"byteOffset":)" + std::to_string(at) + R"(,"byteLength":)" +
         std::to_string(bytes) + R"(,"target":)" + std::to_string(target) + "}";
}

struct Mesh {
  std::vector<Vector> places, normals;
  std::vector<std::array<std::uint16_t, 4>> colours;
  std::vector<Triangle> triangles;

  std::uint64_t vectorBytes() const { return places.size() * sizeof(Vector); }
  std::uint64_t colourBytes() const { return colours.size() * 8; }
  std::uint64_t indexBytes() const { return triangles.size() * sizeof(Triangle); }
  std::uint64_t bytes() const { return 2 * vectorBytes() + colourBytes() + indexBytes(); }
};

std::string jsonOf(const Mesh& mesh, const ExportGrid& grid, const Axes& axes) {
  Vector least = mesh.places.front();
  Vector most = least;
  for (const Vector& p : mesh.places) {
    for (std::size_t k = 0; k < 3; ++k) {
      least[k] = std::min(least[k], p[k]);
      most[k] = std::max(most[k], p[k]);
    }
  }
  const std::string vertices = std::to_string(mesh.places.size());
  const bool coloured = !mesh.colours.empty();
  const std::string indices = coloured ? "3" : "2";
  std::string middle = roundTripText(axes.middle());
  for (char& c : middle) c = c == ' ' ? ',' : c;
  std::string json =
      R"({"asset":{"version":"2.0","generator":"relievo )" RELIEVO_VERSION_STRING
      R"("},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0,"name":"relief","extras":{"unit":")" +
      grid.unit + R"(","middle":[)" + middle +
      R"(]}}],"meshes":[{"primitives":[{"attributes":{"POSITION":0,"NORMAL":1)" +
      (coloured ? R"(,"COLOR_0":2)" : "") + R"(},"indices":)" + indices +
      R"(,"material":0}]}],"materials":[{"name":"stone","doubleSided":true,"pbrMetallicRoughness":{"baseColorFactor":)" +
      (coloured ? "[1,1,1,1]" : "[0.8,0.78,0.74,1]") +
      R"(,"metallicFactor":0,"roughnessFactor":0.9}}],"accessors":[{"bufferView":0,"componentType":5126,"count":)" +
      vertices + R"(,"type":"VEC3","min":)" + triple(least) + R"(,"max":)" + triple(most) +
      R"(},{"bufferView":1,"componentType":5126,"count":)" + vertices + R"(,"type":"VEC3"})";
  if (coloured) {
    json += R"(,{"bufferView":2,"componentType":5123,"normalized":true,"count":)" + vertices +
            R"(,"type":"VEC4"})";
  }
  json += R"(,{"bufferView":)" + indices + R"(,"componentType":5125,"count":)" +
          std::to_string(3 * mesh.triangles.size()) + R"(,"type":"SCALAR"}],"bufferViews":[)";
  constexpr int kVertices = 34962;
  std::uint64_t at = 0;
  for (const std::uint64_t bytes : {mesh.vectorBytes(), mesh.vectorBytes(), mesh.colourBytes()}) {
    if (bytes == 0) continue;
    json += view(at, bytes, kVertices) + ",";
    at += bytes;
  }
  json += view(at, mesh.indexBytes(), 34963) + R"(],"buffers":[{"byteLength":)" +
          std::to_string(mesh.bytes()) + "}]}";
  json.resize((json.size() + 3) / 4 * 4, ' ');
  return json;
}

Mesh meshOf(const ExportGrid& grid, const Axes& axes, const Task& task) {
  Mesh mesh;
  std::uint32_t count = 0;
  mesh.triangles = trianglesBetween(grid, vertexNumbers(grid, count));
  if (mesh.triangles.empty()) {
    throw failure<MessageId::export_gltf_without_surface>();
  }
  mesh.places.reserve(count);
  for (int row = 0; row < grid.size.rows; ++row) {
    if (static_cast<std::size_t>(row) % kRowsBetweenLooks == 0) task.check();
    for (int col = 0; col < grid.size.cols; ++col) {
      const std::size_t i = grid.size.index({col, row});
      if (!grid.holds(i)) continue;
      mesh.places.push_back(
          axes.place(xOf(grid, col), yOf(grid, row), static_cast<double>(grid.heights[i])));
    }
  }
  mesh.normals = normalsOf(mesh.places, mesh.triangles);
  makeUnit(mesh.normals, axes.turned({0, 0, 1}));
  mesh.colours = coloursOf(grid);
  return mesh;
}

}  // namespace

void writeGltf(const std::filesystem::path& file, const ExportGrid& grid, const Task& task) {
  const Axes axes(grid);
  const Mesh mesh = meshOf(grid, axes, task);
  const std::string json = jsonOf(mesh, grid, axes);
  const std::uint64_t bytes = 12 + 8 + json.size() + 8 + mesh.bytes();
  if (bytes > std::numeric_limits<std::uint32_t>::max()) {
    throw failure<MessageId::export_gltf_too_large>();
  }
  task.check();
  ExportFile out(file);
  out.bytes(std::array{kMagic, std::uint32_t{2}, static_cast<std::uint32_t>(bytes)});
  out.bytes(std::array{static_cast<std::uint32_t>(json.size()), kJson});
  out << json;
  out.bytes(std::array{static_cast<std::uint32_t>(mesh.bytes()), kBinary});
  out.array(mesh.places);
  out.array(mesh.normals);
  out.array(mesh.colours);
  out.array(mesh.triangles);
  out.commit();
}

}  // namespace relievo
