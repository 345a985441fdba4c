// SPDX-License-Identifier: BSD-3-Clause
#include "core/depth/rules/cell_size.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "core/message/catalogue.h"

namespace relievo {
namespace {

constexpr int kPaperCells = 800;        // Paper, sec. 6: depth data of 800 x 800.
constexpr int kFewestCells = 24;        // Less is no picture.
constexpr int kMostCells = 4096;        // More is asked for, not proposed.
constexpr double kPointsPerCell = 2.5;  // surface of 2 to 4 points a cell: few gaps, little lost.

struct Planar {
  std::vector<double> x, y;  // Scan coordinates after rotation, file units.
};

Planar projected(const Scan& scan, const Rotation& r, std::size_t most) {
  Planar planar;
  const std::size_t count = scan.points.size();
  const std::size_t taken = std::min(count, most);
  // Scans are stored row by row; an even stride would see every n-th column only. Steps of the
  // golden ratio visit them all alike.
  constexpr double kGoldenRatio = 0.6180339887498949;
  double position = 0;
  planar.x.reserve(taken);
  planar.y.reserve(taken);
  for (std::size_t i = 0; i < taken; ++i) {
    const std::size_t chosen =
        taken == count ? i : static_cast<std::size_t>(position * static_cast<double>(count));
    position += kGoldenRatio;
    if (position >= 1) position -= 1;
    const FilePoint p = scan.point(chosen);
    planar.x.push_back(r[0] * p.x + r[1] * p.y + r[2] * p.z);
    planar.y.push_back(r[3] * p.x + r[4] * p.y + r[5] * p.z);
  }
  return planar;
}

/// Rising. Into as many even steps of their range as there are values, first: that takes the time
/// of a few looks at each, where sorting at once takes a quarter of an open cloud's judgement.
void sortSpread(std::vector<double>& values) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const double first = *low;
  const double range = *high - first;
  if (!(range > 0) || !std::isfinite(range)) return std::sort(values.begin(), values.end());
  const std::size_t steps = values.size();
  const double per_unit = static_cast<double>(steps - 1) / range;
  const auto step = [&](double value) {
    return std::min(static_cast<std::size_t>((value - first) * per_unit), steps - 1);
  };
  std::vector<std::uint32_t> ends(steps + 1);  // First where each step begins.
  for (const double value : values) ++ends[step(value) + 1];
  std::partial_sum(ends.begin(), ends.end(), ends.begin());
  std::vector<double> placed(values.size());
  for (const double value : values) placed[ends[step(value)]++] = value;
  std::size_t begin = 0;
  for (std::size_t s = 0; s < steps; ++s) {
    const auto at = [&](std::size_t i) { return placed.begin() + static_cast<std::ptrdiff_t>(i); };
    if (ends[s] - begin > 1) std::sort(at(begin), at(ends[s]));
    begin = ends[s];
  }
  values = std::move(placed);
}

/// Distance of the lines that all values lie on, if they lie on evenly spaced lines.
std::optional<double> evenSpacing(std::vector<double> values) {
  const std::size_t count = values.size();
  sortSpread(values);
  const double range = values.back() - values.front();
  // Values closer than this are the same line: float rounding at this range.
  const double same = 1e-5 * range;
  std::vector<double> steps;
  for (std::size_t i = 1; i < count; ++i) {
    const double step = values[i] - values[i - 1];
    if (step > same) steps.push_back(step);
  }
  if (steps.empty() || steps.size() * 8 > count) return std::nullopt;
  std::vector<double> sorted = steps;
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  const double spacing = *middle;
  const bool even = std::all_of(steps.begin(), steps.end(), [&](double step) {
    const double lines = std::round(step / spacing);
    return lines >= 1 && std::abs(step - lines * spacing) < 0.02 * spacing;
  });
  if (!even) return std::nullopt;
  // The range over the number of lines is more exact than any single step.
  return range / std::round(range / spacing);
}

/// Area that the points cover, on a grid coarse enough that chance leaves few cells empty.
double coveredArea(const Planar& planar, double left, double bottom, double side) {
  const auto count = static_cast<double>(planar.x.size());
  const int across = std::clamp(static_cast<int>(std::sqrt(count) / 4), 4, 128);
  const double cell = side / across;
  std::vector<bool> hit(static_cast<std::size_t>(across) * static_cast<std::size_t>(across));
  const auto index = [&](double position, double start) {
    return static_cast<std::size_t>(
        std::clamp(static_cast<int>((position - start) / cell), 0, across - 1));
  };
  for (std::size_t i = 0; i < planar.x.size(); ++i) {
    hit[index(planar.y[i], bottom) * static_cast<std::size_t>(across) + index(planar.x[i], left)] =
        true;
  }
  return static_cast<double>(std::count(hit.begin(), hit.end(), true)) * cell * cell;
}

/// 2.59 is said as 2.5: no cell is promised more points than it has. 2.4999996 is 2.5 itself.
NumberArgument roundedDown(double value) {
  return {.value = std::floor(std::round(1e6 * value) / 1e5) / 10, .digits = 1};
}

}  // namespace

CellProposal proposeCells(const Scan& scan, const Rotation& rotation, std::uint64_t points_in_all) {
  if (!scan.triangles.empty()) {
    return {.cells = kPaperCells, .reason = said<MessageId::grid_of_mesh>()};
  }
  const Planar planar = projected(scan, rotation, 200'000);
  const auto [left, right] = std::minmax_element(planar.x.begin(), planar.x.end());
  const auto [bottom, top] = std::minmax_element(planar.y.begin(), planar.y.end());
  const double side = std::max(*right - *left, *top - *bottom);
  if (!(side > 0)) return {.cells = 2, .reason = said<MessageId::grid_of_one_spot>()};

  const auto count =
      static_cast<double>(std::max<std::uint64_t>(scan.points.size(), points_in_all));
  const std::optional<double> step_x = evenSpacing(planar.x);
  const std::optional<double> step_y = step_x ? evenSpacing(planar.y) : std::nullopt;
  if (step_x && step_y && std::abs(*step_x - *step_y) < 0.01 * *step_x) {
    const double nodes = ((*right - *left) / *step_x + 1) * ((*top - *bottom) / *step_y + 1);
    const double across = std::round(side / *step_x) + 1;
    if (count > 0.3 * nodes && across <= kMostCells) {
      return {.cells = static_cast<int>(across), .reason = said<MessageId::grid_of_the_points>()};
    }
  }
  return proposeCells({.side_mm = side,
                       .covered_mm2 = coveredArea(planar, *left, *bottom, side),
                       .points = std::max<std::uint64_t>(scan.points.size(), points_in_all),
                       .points_per_cell = kPointsPerCell});
}

CellProposal proposeCells(const CoveredArea& covered) {
  const auto count = static_cast<double>(covered.points);
  const double area = covered.covered_mm2;
  const double wanted =
      std::round(covered.side_mm / std::sqrt(covered.points_per_cell * area / count)) + 1;
  const int cells = static_cast<int>(std::clamp<double>(wanted, kFewestCells, kMostCells));
  const double spacing = covered.side_mm / (cells - 1);
  return {
      .cells = cells,
      .reason = said<MessageId::grid_by_density>(roundedDown(count * spacing * spacing / area))};
}

}  // namespace relievo
