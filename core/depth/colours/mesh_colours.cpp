// SPDX-License-Identifier: BSD-3-Clause
#include "core/depth/colours/mesh_colours.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/base/bands.h"
#include "core/depth/colours/colour_fill.h"
#include "core/depth/colours/linear_light.h"
#include "core/depth/colours/texture_levels.h"
#include "core/depth/rules/triangle_rows.h"

namespace relievo {
namespace {

using Shares = std::array<double, 3>;  ///< Of a triangle's corners; they sum to 1.

struct Triangle {
  std::size_t index = 0;
  GridPoint a, b, c;
  double double_area = 0;

  Shares sharesAt(int col, int row) const {
    const auto part = [&](const GridPoint& p, const GridPoint& q) {
      return std::max(0.0, ((p.u - col) * (q.v - row) - (q.u - col) * (p.v - row)) / double_area);
    };
    const Shares shares{part(b, c), part(c, a), part(a, b)};
    const double sum = shares[0] + shares[1] + shares[2];
    return {shares[0] / sum, shares[1] / sum, shares[2] / sum};
  }
};

class CornerColours {
 public:
  static constexpr std::size_t kChannels = 3;
  using Light = std::optional<std::array<float, kChannels>>;
  CornerColours(const Scan& scan, const Task& task) : scan_(scan) {
    if (scan.texture_of.size() != scan.triangles.size() ||
        scan.texture_corners.size() != scan.triangles.size()) {
      return;
    }
    textures_.reserve(scan.textures.size());
    for (const Texture& texture : scan.textures) textures_.emplace_back(texture, task);
  }

  Light at(const Triangle& triangle, int col, int row) const {
    const Shares shares = triangle.sharesAt(col, row);
    if (!textures_.empty() && scan_.texture_of[triangle.index] < textures_.size()) {
      return ofTexture(triangle, shares);
    }
    if (scan_.colours.size() != scan_.points.size()) return std::nullopt;
    std::array<double, 3> sums{};
    double weights = 0;
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const Rgba& colour = scan_.colours[scan_.triangles[triangle.index][corner]];
      if (colour[3] == 0) continue;
      for (std::size_t k = 0; k < 3; ++k) {
        sums[k] += shares[corner] * transfer_.light[colour[k]];
      }
      weights += shares[corner];
    }
    // Nearer to a corner without colour than to the others there is none.
    if (!(weights >= 0.5)) return std::nullopt;
    std::array<float, 3> light{};
    for (std::size_t k = 0; k < 3; ++k) light[k] = static_cast<float>(sums[k] / weights);
    return light;
  }

 private:
  Light ofTexture(const Triangle& t, const Shares& shares) const {
    const TextureLevels& texture = textures_[scan_.texture_of[t.index]];
    const TextureCorners& corners = scan_.texture_corners[t.index];
    const auto value = [&](std::size_t corner, std::size_t axis) {
      return static_cast<double>(corners[corner][axis]);
    };
    const auto mean = [&](std::size_t axis) {
      return shares[0] * value(0, axis) + shares[1] * value(1, axis) + shares[2] * value(2, axis);
    };
    const double to_b_u = t.b.u - t.a.u;
    const double to_b_v = t.b.v - t.a.v;
    const double to_c_u = t.c.u - t.a.u;
    const double to_c_v = t.c.v - t.a.v;
    // Texels from one sample to the next, along the grid's two axes.
    std::array<double, 2> along_u{};
    std::array<double, 2> along_v{};
    const std::array<double, 2> texels{static_cast<double>(texture.cols()),
                                       static_cast<double>(texture.rows())};
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const double to_b = (value(1, axis) - value(0, axis)) * texels[axis] / t.double_area;
      const double to_c = (value(2, axis) - value(0, axis)) * texels[axis] / t.double_area;
      along_u[axis] = to_b * to_c_v - to_c * to_b_v;
      along_v[axis] = to_c * to_b_u - to_b * to_c_u;
    }
    return texture.at(
        mean(0), mean(1),
        std::max(std::hypot(along_u[0], along_u[1]), std::hypot(along_v[0], along_v[1])));
  }

  const Scan& scan_;
  const Transfer& transfer_ = sRgb();
  std::vector<TextureLevels> textures_;
};

class CornerIntensities {
 public:
  static constexpr std::size_t kChannels = 1;
  CornerIntensities(const Scan& scan, std::span<const std::uint16_t> light)
      : scan_(scan), light_(light) {}
  std::optional<std::array<float, 1>> at(const Triangle& triangle, int col, int row) const {
    const Shares shares = triangle.sharesAt(col, row);
    const auto& corners = scan_.triangles[triangle.index];
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) sum += shares[i] * light_[corners[i]];
    return std::array<float, 1>{static_cast<float>(sum)};
  }

 private:
  const Scan& scan_;
  std::span<const std::uint16_t> light_;
};

/// A band of rows that remembers how near its samples are.
template <class Source>
class MeshBand {
 public:
  static constexpr std::size_t kChannels = Source::kChannels;

  MeshBand(const DepthMap& map, const Source& source, const Transfer& transfer, int first, int end,
           std::vector<Pixel<kChannels>>& out)
      : map_(map),
        source_(source),
        transfer_(transfer),
        first_(first),
        end_(end),
        start_(map.frame.size.index({.col = 0, .row = first})),
        z_mm_(map.frame.size.index({.col = 0, .row = end}) - start_,
              -std::numeric_limits<float>::infinity()),
        out_(out) {}

  void draw(const Triangle& t) {
    if (std::abs(t.double_area) < kLeastDoubleArea) return;
    const TrianglePlane plane(t.a, t.b, t.c, t.double_area);
    const GridSize size = map_.frame.size;
    forEachSample(t.a, t.b, t.c, size, first_, end_, [&](int col, int row) {
      const std::size_t cell = size.index({.col = col, .row = row});
      const auto z = static_cast<float>(plane.zAt(col, row));
      if (!(z > z_mm_[cell - start_])) return;
      z_mm_[cell - start_] = z;
      const CellStatus origin = map_.origins[cell];
      if (origin != CellStatus::measured && origin != CellStatus::steep) return;
      Pixel<kChannels>& pixel = out_[cell];
      pixel = {};
      const auto light = source_.at(t, col, row);
      if (!light) return;
      for (std::size_t k = 0; k < kChannels; ++k) pixel[k] = transfer_.storedOf((*light)[k]);
      pixel[kChannels] = kStoredAlpha;
    });
  }

 private:
  const DepthMap& map_;
  const Source& source_;
  const Transfer& transfer_;
  int first_, end_;
  std::size_t start_;
  std::vector<float> z_mm_;
  std::vector<Pixel<kChannels>>& out_;
};

template <class Source>
std::vector<Pixel<Source::kChannels>> meshPixels(const DepthRequest& request, const DepthMap& map,
                                                 const Source& source, const Transfer& transfer,
                                                 const Task& task) {
  const GridFromPoint grid_from_point(request);
  std::vector<GridPoint> corners;
  corners.reserve(request.scan.points.size());
  for (const auto& point : request.scan.points) corners.push_back(grid_from_point(point));
  const GridSize size = map.frame.size;
  std::vector<Pixel<Source::kChannels>> pixels(size.count(), Pixel<Source::kChannels>{});
  const auto& triangles = request.scan.triangles;
  const int threads = threadsFor(size.count() + triangles.size(), request.threads);
  parallelFor(size.rows, threads, [&](int first, int end) {
    MeshBand<Source> band(map, source, transfer, first, end, pixels);
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      if (i % 1024 == 0) task.check();
      Triangle t{.index = i,
                 .a = corners[triangles[i][0]],
                 .b = corners[triangles[i][1]],
                 .c = corners[triangles[i][2]]};
      t.double_area = doubleArea(t.a, t.b, t.c);
      band.draw(t);
    }
  });
  return pixels;
}

}  // namespace

std::vector<Rgba> meshColours(const DepthRequest& request, const DepthMap& map, const Task& task) {
  return meshPixels(request, map, CornerColours(request.scan, task), sRgb(), task);
}

std::vector<GreyAlpha> meshIntensities(const DepthRequest& request, const DepthMap& map,
                                       std::span<const std::uint16_t> light, const Task& task) {
  return meshPixels(request, map, CornerIntensities(request.scan, light), proportional(), task);
}

}  // namespace relievo
