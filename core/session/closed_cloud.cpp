// SPDX-License-Identifier: BSD-3-Clause
#include "core/session/closed_cloud.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "core/base/bands.h"
#include "core/depth/layers/layers.h"

namespace relievo {
namespace {

constexpr std::size_t kBlock = 4096;
constexpr std::size_t kSample = 50'000;
// The front is known between the points, too: cells need fewer of them than an open cloud's.
constexpr double kPointsOfCell = 1.5;
constexpr double kNoiseOfCell = 0.4;  // Of the cell's width, in the mean of its points.
constexpr float kBehind = 0.7F;  // Spacings; a height farther behind the front is one of the back.

/// The scan's points in view millimetres, from the box's lower corner.
class FromCorner {
 public:
  FromCorner(const Scan& scan, const Rotation& rotation, double mm, const RotatedBounds& box)
      : points_(scan.points) {
    for (std::size_t i = 0; i < 9; ++i) m_[i] = mm * rotation[i];
    const FilePoint& o = scan.origin;
    // The large part (UTM easting, northing) is added once, in double.
    shift_ =
        ViewMm{m_[0] * o.x + m_[1] * o.y + m_[2] * o.z, m_[3] * o.x + m_[4] * o.y + m_[5] * o.z,
               m_[6] * o.x + m_[7] * o.y + m_[8] * o.z} -
        box.min;
  }

  std::size_t count() const { return points_.size(); }
  ViewMm operator()(std::size_t i) const {
    const auto x = static_cast<double>(points_[i][0]);
    const auto y = static_cast<double>(points_[i][1]);
    const auto z = static_cast<double>(points_[i][2]);
    return {m_[0] * x + m_[1] * y + m_[2] * z + shift_.x,
            m_[3] * x + m_[4] * y + m_[5] * z + shift_.y,
            m_[6] * x + m_[7] * y + m_[8] * z + shift_.z};
  }

 private:
  const std::vector<std::array<float, 3>>& points_;
  std::array<double, 9> m_{};
  ViewMm shift_;
};

/// Steps of the golden ratio: scans are stored row by row, an even stride would see every n-th
/// column only.
std::vector<ViewMm> sampleOf(const FromCorner& points) {
  constexpr double kGoldenRatio = 0.6180339887498949;
  const std::size_t taken = std::min(points.count(), kSample);
  std::vector<ViewMm> sample;
  sample.reserve(taken);
  double position = 0;
  for (std::size_t i = 0; i < taken; ++i) {
    sample.push_back(
        points(taken == points.count()
                   ? i
                   : static_cast<std::size_t>(position * static_cast<double>(points.count()))));
    position += kGoldenRatio;
    if (position >= 1) position -= 1;
  }
  return sample;
}

/// Does the front rise by less than a steep cell does, across the cell both ways? Points of a wall
/// beside it, and strays, make a cell look steep that is not; so does noise, by which the front may
/// be off at both sides, across itself.
bool isGentle(const FrontSurface& front, double x_mm, double y_mm, double spacing_mm) {
  // Sideways it may be off as much: what lies no farther than that from the border of the cell may
  // be beyond it.
  const double half = spacing_mm / 2 - std::min(2 * front.noiseMm(), spacing_mm / 4);
  const double off_mm = 2 * front.noiseMm() * std::hypot(1.0, kSteepRise);
  const auto limit = static_cast<float>(kSteepRise * 2 * half + off_mm);
  const float across = front.depthAt(x_mm + half, y_mm) - front.depthAt(x_mm - half, y_mm);
  const float along = front.depthAt(x_mm, y_mm + half) - front.depthAt(x_mm, y_mm - half);
  return std::abs(across) <= limit && std::abs(along) <= limit;  // Not for NaN.
}

}  // namespace

std::optional<ClosedCloud> closedCloud(const Scan& scan, const Rotation& rotation,
                                       double mm_per_unit, const RotatedBounds& box,
                                       const Task& task) {
  if (!scan.triangles.empty()) return std::nullopt;
  const FromCorner from_corner(scan, rotation, mm_per_unit, box);
  const std::size_t count = scan.points.size();
  const ViewBlocks blocks = [&](const std::function<void(std::span<const ViewMm>)>& take) {
    std::array<ViewMm, kBlock> block;
    for (std::size_t first = 0; first < count; first += kBlock) {
      const std::size_t size = std::min(kBlock, count - first);
      for (std::size_t i = 0; i < size; ++i) block[i] = from_corner(first + i);
      take({block.data(), size});
    }
  };
  std::optional<FrontSurface> front =
      frontOf(blocks, sampleOf(from_corner), {.min = {}, .max = box.max - box.min}, count, task);
  if (!front) return std::nullopt;
  ClosedCloud closed{.surface = std::move(*front), .visible = {}};
  const int threads = threadsFor(count, 0);
  struct Part {
    std::vector<std::array<float, 3>> visible;
    std::size_t hidden = 0, strays = 0;
  };
  std::vector<Part> parts(static_cast<std::size_t>(threads));
  parallelFor(threads, threads, [&](int number, int) {
    Part& part = parts[static_cast<std::size_t>(number)];
    const std::size_t begin = count * static_cast<std::size_t>(number) / parts.size();
    const std::size_t end = count * (static_cast<std::size_t>(number) + 1) / parts.size();
    for (std::size_t i = begin; i < end; ++i) {
      if (i % (1U << 16U) == 0) task.check();
      const FrontSurface::Side side = closed.surface.sideOf(from_corner(i));
      part.hidden += side == FrontSurface::Side::hidden ? 1 : 0;
      part.strays += side == FrontSurface::Side::stray ? 1 : 0;
      if (side == FrontSurface::Side::front) part.visible.push_back(scan.points[i]);
    }
  });
  closed.visible.info = scan.info;
  closed.visible.origin = scan.origin;
  for (Part& part : parts) {
    closed.hidden += part.hidden;
    closed.strays += part.strays;
    if (closed.visible.points.empty()) {
      closed.visible.points = std::move(part.visible);
    } else {
      closed.visible.points.insert(closed.visible.points.end(), part.visible.begin(),
                                   part.visible.end());
    }
  }
  // A shape in which no surface is to be found stays what it was.
  if (2 * closed.strays > count || closed.visible.points.empty()) return std::nullopt;
  const FromCorner visible_from_corner(closed.visible, rotation, mm_per_unit, box);
  closed.noise_mm = noiseOnFront(closed.surface, closed.visible.points.size(), visible_from_corner);
  return closed;
}

double noiseOnFront(const FrontSurface& front, std::size_t points,
                    const std::function<ViewMm(std::size_t)>& from_corner) {
  constexpr std::size_t kAsked = 20'000;
  const std::size_t step = points / kAsked + 1;
  std::vector<double> off;
  for (std::size_t i = 0; i < points; i += step) {
    const ViewMm p = from_corner(i);
    const auto z = static_cast<double>(front.depthAt(p.x, p.y));
    if (z == z) off.push_back(std::abs(p.z - z));
  }
  if (off.empty()) return 0;
  const auto middle = off.begin() + static_cast<std::ptrdiff_t>(off.size() / 2);
  std::nth_element(off.begin(), middle, off.end());
  constexpr double kDeviationOfMedian = 1.4826;  // Of normal errors.
  return kDeviationOfMedian * *middle;
}

std::optional<FrontSurface> frontOf(const ViewBlocks& points, const std::vector<ViewMm>& sample,
                                    const ViewBox& box, std::uint64_t count, const Task& task) {
  if (!liesInLayers(sample)) return std::nullopt;
  return FrontSurface(points, box, count, task);
}

CellProposal cellsOf(const FrontSurface& front, const RotatedBounds& box, std::uint64_t points,
                     double noise_mm) {
  const ViewMm size = box.max - box.min;
  const double area = front.coveredMm2();
  const double spacing = std::sqrt(area / static_cast<double>(std::max<std::uint64_t>(points, 1)));
  // The mean of n points errs by noise / sqrt(n), its cell is sqrt(n) spacings wide.
  const double of_cell = std::max(kPointsOfCell, noise_mm / (kNoiseOfCell * spacing));
  return proposeCells({.side_mm = std::max(size.x, size.y),
                       .covered_mm2 = area,
                       .points = points,
                       .points_per_cell = of_cell});
}

void addHidden(const FrontSurface& front, double hidden_points, const OriginCounts& cells,
               HiddenSurface& hidden) {
  const std::size_t all = std::accumulate(cells.begin(), cells.end(), std::size_t{0});
  const auto inside =
      static_cast<double>(all - cells[static_cast<std::size_t>(CellStatus::outside)]);
  hidden.hidden += hidden_points;
  hidden.all += hidden_points;
  hidden.cells = static_cast<std::size_t>(std::lround(front.behind().hidden * inside));
  hidden.cells_in_layers = static_cast<std::size_t>(std::lround(front.behind().in_layers * inside));
}

void addFront(const FrontSurface& front, const GridFrame& frame, const FrontRows& to) {
  const auto same = static_cast<float>(front.spacingMm());
  std::size_t i = 0;
  for (int row = to.rows.first; row < to.rows.end; ++row) {
    for (int col = 0; col < frame.size.cols; ++col, ++i) {
      const double x = col * frame.spacing_mm;
      const double y = row * frame.spacing_mm;
      const float z = front.depthAt(x, y);
      float& depth = to.depths[i];
      if (depth < z - kBehind * same) depth = std::numeric_limits<float>::quiet_NaN();
      if (to.steep != nullptr && to.steep[i] != 0 && isGentle(front, x, y, frame.spacing_mm)) {
        to.steep[i] = 0;
      }
      if (depth == depth) continue;
      float& between = to.between[i];
      if (!(std::abs(between - z) <= same)) between = z;
    }
  }
}

void addFront(const FrontSurface& front, const GridFrame& frame, CapturedDepths& depths) {
  if (depths.between.empty()) {
    depths.between.assign(frame.size.count(), std::numeric_limits<float>::quiet_NaN());
  }
  parallelFor(frame.size.rows, threadsFor(8 * frame.size.count(), 0), [&](int first, int end) {
    const std::size_t at = frame.size.index({.col = 0, .row = first});
    addFront(front, frame,
             {.rows = {.first = first, .end = end},
              .depths = &depths.front[at],
              .between = &depths.between[at],
              .steep = depths.steep.empty() ? nullptr : &depths.steep[at]});
  });
}

}  // namespace relievo
