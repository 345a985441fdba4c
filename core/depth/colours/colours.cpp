// SPDX-License-Identifier: BSD-3-Clause
#include "core/depth/colours/colours.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>
#include <utility>

#include "core/base/bands.h"
#include "core/depth/colours/cell_colours.h"
#include "core/depth/colours/colour_fill.h"
#include "core/depth/colours/linear_light.h"
#include "core/depth/colours/mesh_colours.h"
#include "core/depth/rules/grid_points.h"

namespace relievo {
namespace {

constexpr std::size_t kCellsAtOnce = std::size_t{1} << 24U;  // Their sums take 256 MB.
constexpr std::size_t kPointsBetweenChecks = std::size_t{1} << 16U;

class PointColours {
 public:
  static constexpr std::size_t kChannels = 3;
  explicit PointColours(const Scan& scan) : scan_(scan) {}
  /// @return  false where the point has none
  bool at(std::size_t point, Light<3>& out) const {
    const Rgba& colour = scan_.colours[point];
    for (std::size_t k = 0; k < 3; ++k) out[k] = transfer_.light[colour[k]];
    return colour[3] != 0;
  }

 private:
  const Scan& scan_;
  const Transfer& transfer_ = sRgb();
};

IntensityCounts countsOf(const Scan& scan) {
  IntensityCounts counts(65536);
  for (const std::uint16_t intensity : scan.intensities) ++counts[intensity];
  return counts;
}

class PointIntensities {
 public:
  static constexpr std::size_t kChannels = 1;
  explicit PointIntensities(const Scan& scan) : scan_(scan), stretch_(countsOf(scan)) {}
  bool at(std::size_t point, Light<1>& out) const {
    out[0] = stretch_.light(scan_.intensities[point]);
    return true;
  }

 private:
  const Scan& scan_;
  IntensityStretch stretch_;
};

struct Rows {
  int first = 0, end = 0;
};

/// A point that lies on the rows looked at.
struct PlacedPoint {
  std::size_t point = 0, cell = 0;
  float z = 0;
};

/// Adds every point to its cell, if the cell lies in rows first ... end - 1 and has its height from
/// about there. Points are placed some at a time, and what they will ask for is fetched meanwhile:
/// the cells of a cloud in no order are each far from the last.
/// @param cells  of rows from `start_row` on
template <class CellSums, class Source>
void addPoints(const DepthRequest& request, const DepthMap& map, const Source& source, Rows rows,
               int start_row, std::vector<CellSums>& cells, const Task& task) {
  constexpr std::size_t kAtOnce = 128;
  const GridSize size = map.frame.size;
  const GridFromPoint grid_from_point(request);
  const std::size_t start = size.index({.col = 0, .row = start_row});
  const auto& points = request.scan.points;
  std::array<PlacedPoint, kAtOnce> placed;
  Light<Source::kChannels> light{};
  for (std::size_t begin = 0; begin < points.size(); begin += kAtOnce) {
    if (begin % kPointsBetweenChecks == 0) task.check();
    std::size_t count = 0;
    for (std::size_t i = begin; i < std::min(begin + kAtOnce, points.size()); ++i) {
      const GridPoint p = grid_from_point(points[i]);
      const int row = nearestIndex(p.v, size.rows);
      if (row < rows.first || row >= rows.end) continue;
      const int col = nearestIndex(p.u, size.cols);
      if (col < 0) continue;
      const std::size_t cell = size.index({.col = col, .row = row});
      __builtin_prefetch(&map.heights_mm[cell]);
      __builtin_prefetch(&map.origins[cell]);
      __builtin_prefetch(&cells[cell - start], 1);
      placed[count++] = {.point = i, .cell = cell, .z = static_cast<float>(p.z)};
    }
    for (std::size_t k = 0; k < count; ++k) {
      const auto& [point, cell, z] = placed[k];
      if (!isOfLayer(z, map.heights_mm[cell], map.frame.spacing_mm)) continue;
      if (!takesColours(map.origins[cell]) || !source.at(point, light)) continue;
      cells[cell - start].add(light, z);
    }
  }
}

/// Every band of rows looks at all points and takes its own: no two threads write the same cell.
template <template <std::size_t> class CellSums, class Source>
std::vector<Pixel<Source::kChannels>> pointPixels(const DepthRequest& request, const DepthMap& map,
                                                  const Source& source, const Transfer& transfer,
                                                  const Task& task) {
  constexpr std::size_t kChannels = Source::kChannels;
  const GridSize size = map.frame.size;
  std::vector<Pixel<kChannels>> pixels(size.count(), Pixel<kChannels>{});
  const int rows_at_once = std::max(
      1, static_cast<int>(kCellsAtOnce / static_cast<std::size_t>(std::max(size.cols, 1))));
  const int threads = threadsFor(request.scan.points.size(), request.threads);
  for (int start_row = 0; start_row < size.rows; start_row += rows_at_once) {
    const int rows = std::min(rows_at_once, size.rows - start_row);
    std::vector<CellSums<kChannels>> cells(static_cast<std::size_t>(rows) *
                                           static_cast<std::size_t>(size.cols));
    Pixel<kChannels>* const out = &pixels[size.index({.col = 0, .row = start_row})];
    parallelFor(rows, threads, [&](int first, int end) {
      addPoints(request, map, source, {.first = start_row + first, .end = start_row + end},
                start_row, cells, task);
      const auto at = [&](int row) {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(size.cols);
      };
      for (std::size_t i = at(first); i < at(end); ++i) {
        out[i] = pixelOf<kChannels>(cells[i], transfer);
      }
    });
  }
  return pixels;
}

template <class Source>
std::vector<Pixel<Source::kChannels>> pointPixels(const DepthRequest& request, const DepthMap& map,
                                                  const Source& source, ColourRule rule,
                                                  const Transfer& transfer, const Task& task) {
  return rule == ColourRule::winner ? pointPixels<FrontCell>(request, map, source, transfer, task)
                                    : pointPixels<MeanCell>(request, map, source, transfer, task);
}

template <std::size_t Channels>
void finish(std::vector<Pixel<Channels>>& pixels, const DepthMap& map, const Transfer& transfer,
            int threads, const Task& task) {
  fillColours<Channels>(pixels, map, transfer, threads, task);
  const bool any = std::any_of(pixels.begin(), pixels.end(),
                               [](const Pixel<Channels>& pixel) { return pixel[Channels] != 0; });
  if (!any) pixels = {};
}

}  // namespace

bool hasColours(const Scan& scan) {
  const bool on_points = scan.colours.size() == scan.points.size() &&
                         std::any_of(scan.colours.begin(), scan.colours.end(),
                                     [](const Rgba& c) { return c[3] != 0; });
  if (on_points) return true;
  return scan.texture_of.size() == scan.triangles.size() &&
         scan.texture_corners.size() == scan.triangles.size() &&
         std::any_of(scan.texture_of.begin(), scan.texture_of.end(), [&](std::uint16_t texture) {
           return texture < scan.textures.size() && !scan.textures[texture].texels.empty();
         });
}

bool hasIntensities(const Scan& scan) {
  return !scan.intensities.empty() && scan.intensities.size() == scan.points.size();
}

IntensityStretch::IntensityStretch(const IntensityCounts& counts) : light_(counts.size()) {
  constexpr double kTail = 0.02;
  const std::uint64_t all = std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
  const auto quantile = [&](double share) {
    const auto wanted = static_cast<std::uint64_t>(share * static_cast<double>(all - 1));
    std::uint64_t seen = 0;
    for (std::size_t i = 0; i < counts.size(); ++i) {
      seen += counts[i];
      if (seen > wanted) return static_cast<std::uint32_t>(i);
    }
    return std::uint32_t{65535};
  };
  low_ = quantile(kTail);
  high_ = quantile(1 - kTail);
  if (high_ <= low_) {  // All the same: mid grey.
    high_ = low_ + 1;
    low_ = low_ > 0 ? low_ - 1 : 0;
  }
  const double range = high_ - low_;
  for (std::size_t i = 0; i < light_.size(); ++i) {
    const double part = (static_cast<double>(i) - low_) / range;
    light_[i] =
        static_cast<std::uint16_t>(std::lround(std::clamp(part, 0.0, 1.0) * Transfer::kMost));
  }
}

IntensityRange IntensityStretch::shown(const std::optional<IntensityRange>& stored) const noexcept {
  const IntensityRange range = stored.value_or(IntensityRange{0, 65535});
  const auto number = [&](std::uint32_t value) {
    return range.low + (range.high - range.low) * value / 65535;
  };
  return {number(low_), number(high_)};
}

IntensityRange shownIntensities(const Scan& scan) {
  return IntensityStretch(countsOf(scan)).shown(scan.info.intensity);
}

GridColours gridColours(const DepthRequest& request, const DepthMap& map, ColourRule rule,
                        const Task& task) {
  const Scan& scan = request.scan;
  GridColours made;
  if (!hasColours(scan) && !hasIntensities(scan)) return made;
  task.report("Colours", 0.0);
  task.check();
  if (hasColours(scan)) {
    made.colours = scan.triangles.empty()
                       ? pointPixels(request, map, PointColours(scan), rule, sRgb(), task)
                       : meshColours(request, map, task);
    finish<3>(made.colours, map, sRgb(), request.threads, task);
  }
  if (hasIntensities(scan)) {
    const PointIntensities source(scan);
    if (scan.triangles.empty()) {
      made.intensities = pointPixels(request, map, source, rule, proportional(), task);
    } else {
      std::vector<std::uint16_t> light;
      light.reserve(scan.points.size());
      for (std::size_t i = 0; i < scan.points.size(); ++i) {
        Light<1> one{};
        source.at(i, one);
        light.push_back(one[0]);
      }
      made.intensities = meshIntensities(request, map, light, task);
    }
    finish<1>(made.intensities, map, proportional(), request.threads, task);
  }
  return made;
}

}  // namespace relievo
