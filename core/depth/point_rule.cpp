// SPDX-License-Identifier: BSD-3-Clause
#include "core/depth/point_rule.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <limits>
#include <mutex>
#include <utility>
#include <vector>

#include "core/base/bands.h"
#include "core/depth/cell_points.h"
#include "core/depth/flyers.h"
#include "core/depth/local_fit.h"

namespace relievo {
namespace {

constexpr float kEmpty = std::numeric_limits<float>::quiet_NaN();
constexpr float kLowest = -std::numeric_limits<float>::infinity();
constexpr double kEnoughToAverage = 4;          // Points a cell.
constexpr double kTopLayerCells = 1.5;          // Depth of the top layer: slopes up to 56 degrees.
constexpr double kOtherLayerCells = 4;          // Points this far apart are not one surface.
constexpr double kMostLayeredShare = 0.05;      // Flyers and walls put that many cells apart.
constexpr float kOnSample = 0.02F;              // Cells; points this near lie on their samples.
constexpr std::size_t kSampledCells = 300'000;  // Enough to choose a rule and to know the noise.

constexpr std::array<std::pair<std::string_view, PointRule>, 7> kNames{
    {{"front", PointRule::front},
     {"second", PointRule::second},
     {"topmean", PointRule::top_mean},
     {"median", PointRule::median},
     {"mean", PointRule::mean},
     {"splat", PointRule::splat},
     {"quadratic", PointRule::quadratic}}};

using CellSpan = std::span<const PlacedPoint>;

float frontMost(CellSpan cell) {
  float highest = kLowest;
  for (const PlacedPoint& p : cell) highest = std::max(highest, p.z);
  return highest;
}

/// Second largest, or the only one.
float secondLargest(CellSpan cell) {
  float first = kLowest;
  float second = kLowest;
  for (const PlacedPoint& p : cell) {
    if (p.z > first) {
      second = std::exchange(first, p.z);
    } else {
      second = std::max(second, p.z);
    }
  }
  return second > kLowest ? second : first;
}

struct Moments {
  double sum = 0, squares = 0;
  std::uint32_t count = 0;

  void add(float z, float about) {
    const double d = static_cast<double>(z) - static_cast<double>(about);
    sum += d;
    squares += d * d;
    ++count;
  }
  double mean(float about) const { return static_cast<double>(about) + sum / count; }
  double deviation() const {
    if (count < 2) return 0;
    return std::sqrt(std::max(0.0, (squares - sum * sum / count) / (count - 1)));
  }
};

/// The second largest stands for the top, so that one point above the surface is not it; the layer
/// is what lies within a small depth of it, either way.
Moments topLayer(CellSpan cell, float top, double spacing_mm) {
  const auto depth = static_cast<float>(kTopLayerCells * spacing_mm);
  Moments layer;
  for (const PlacedPoint& p : cell) {
    if (std::abs(p.z - top) <= depth) layer.add(p.z, top);
  }
  return layer;
}

double medianOf(CellSpan cell, std::vector<float>& heights) {
  heights.clear();
  for (const PlacedPoint& p : cell) heights.push_back(p.z);
  const auto middle = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / 2);
  std::nth_element(heights.begin(), middle, heights.end());
  const auto upper = static_cast<double>(*middle);
  if (heights.size() % 2 == 1) return upper;
  return 0.5 * (upper + static_cast<double>(*std::max_element(heights.begin(), middle)));
}

/// Mean with bilinear weights over the points less than one sample distance away, in x and in y.
std::optional<double> splatAt(const RowPoints& rows, int col, int row) {
  double weights = 0;
  double sum = 0;
  for (int r = std::max(row - 1, rows.first_row); r < std::min(row + 2, rows.end_row); ++r) {
    for (int c = std::max(col - 1, 0); c < std::min(col + 2, rows.cols); ++c) {
      for (const PlacedPoint& p : rows.of(c, c + 1, r)) {
        const double du = std::abs(static_cast<double>(p.du) + (c - col));
        const double dv = std::abs(static_cast<double>(p.dv) + (r - row));
        if (du >= 1 || dv >= 1) continue;
        const double weight = (1 - du) * (1 - dv);
        weights += weight;
        sum += weight * static_cast<double>(p.z);
      }
    }
  }
  if (!(weights > 0)) return std::nullopt;
  return sum / weights;
}

bool hasPointAround(const RowPoints& rows, int col, int row) {
  const int first_col = std::max(col - 1, 0);
  const int end_col = std::min(col + 2, rows.cols);
  for (int r = std::max(row - 1, rows.first_row); r < std::min(row + 2, rows.end_row); ++r) {
    if (rows.count(first_col, end_col, r) > 0) return true;
  }
  return false;
}

/// Does the surface nearest the viewer run down through the cell like a wall?
bool isWall(CellSpan cell, double spacing_mm, std::vector<float>& heights) {
  if (cell.size() < 3) return false;
  heights.clear();
  for (const PlacedPoint& p : cell) heights.push_back(p.z);
  std::sort(heights.begin(), heights.end(), std::greater<>());
  const auto gap = static_cast<float>(kOtherLayerCells * spacing_mm);
  std::size_t last = 1;
  while (last < heights.size() && heights[last - 1] - heights[last] <= gap) ++last;
  return last >= 3 && heights.front() - heights[last - 1] > kSteepRise * spacing_mm;
}

struct Statistics {
  std::size_t points = 0;
  std::size_t inside = 0;  ///< Cells with a point in the 3 x 3 around: the object, gaps included.
  std::size_t occupied = 0, layered = 0, off_samples = 0;

  void add(const RowPoints& rows, int first_row, int end_row, double spacing_mm) {
    const auto apart = static_cast<float>(kOtherLayerCells * spacing_mm);
    for (int row = first_row; row < end_row; ++row) {
      for (int col = 0; col < rows.cols; ++col) {
        const CellSpan cell = rows.of(col, col + 1, row);
        inside += hasPointAround(rows, col, row) ? 1 : 0;
        if (cell.empty()) continue;
        const auto [low, high] = std::minmax_element(
            cell.begin(), cell.end(),
            [](const PlacedPoint& a, const PlacedPoint& b) { return a.z < b.z; });
        points += cell.size();
        ++occupied;
        layered += high->z - low->z > apart ? 1 : 0;
        off_samples += std::max(std::abs(cell[0].du), std::abs(cell[0].dv)) > kOnSample ? 1 : 0;
      }
    }
  }
  double pointsPerCell() const {
    return inside == 0 ? 0 : static_cast<double>(points) / static_cast<double>(inside);
  }
};

int rowsAtOnce(GridSize size) {
  return std::clamp(131'072 / std::max(size.cols, 1), 16, 64);
}

/// Rows that are looked at before the rule is known: all of a small grid, else every n-th unit.
template <class Visit>
void forSampledRows(const CellPoints& points, int halo, const Task& task, Visit&& visit) {
  const GridSize size = points.size();
  const int rows_at_once = rowsAtOnce(size);
  const int units = (size.rows + rows_at_once - 1) / rows_at_once;
  const auto wanted = static_cast<int>(kSampledCells / (static_cast<std::size_t>(rows_at_once) *
                                                        static_cast<std::size_t>(size.cols)) +
                                       1);
  const int step = std::max(1, units / wanted);
  for (int unit = step / 2; unit < units; unit += step) {
    task.check();
    const int first = unit * rows_at_once;
    const int end = std::min(first + rows_at_once, size.rows);
    RowPoints rows = points.rows(first - halo, end + halo);
    visit(rows, first, end);
  }
}

std::string pointsPerCell(const Statistics& found) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.1f points per cell", found.pointsPerCell());
  return text.data();
}

RuleProposal propose(const CellPoints& points, const Task& task) {
  const double spacing = points.request().frame.spacing_mm;
  Statistics found;
  forSampledRows(points, kFlyerReach, task, [&](RowPoints& rows, int first, int end) {
    dropFlyers(rows, spacing, first, end);
    found.add(rows, first, end, spacing);
  });
  RuleProposal proposal{.rule = PointRule::front, .reason = pointsPerCell(found)};
  if (found.occupied == 0) return proposal;
  const auto cells = static_cast<double>(found.occupied);
  const double density = found.pointsPerCell();
  if (density < 1.01 && static_cast<double>(found.off_samples) < 0.01 * cells) {
    proposal.reason = "one point at each sample";
  } else if (static_cast<double>(found.layered) > kMostLayeredShare * cells) {
    proposal.rule = PointRule::top_mean;
    proposal.reason += " in several layers";
  } else {
    proposal.rule = density < kEnoughToAverage ? PointRule::quadratic : PointRule::median;
    if (density >= kEnoughToAverage) proposal.reason += " in one layer";
  }
  return proposal;
}

double noiseOf(const CellPoints& points, const Task& task) {
  const double spacing = points.request().frame.spacing_mm;
  std::vector<double> noises;
  forSampledRows(points, LocalFit::kWidest + kFlyerReach, task,
                 [&](RowPoints& rows, int first, int end) {
                   dropFlyers(rows, spacing, first, end);
                   noises.push_back(noiseOf(rows, first, end, spacing));
                 });
  std::sort(noises.begin(), noises.end());
  return noises.empty() ? 0 : noises[noises.size() / 2];
}

/// Writes the cells of some rows.
class RowWriter {
 public:
  RowWriter(const DepthRequest& request, PointRule rule, double noise_mm, CapturedDepths& out)
      : frame_(request.frame), rule_(rule), fit_(noise_mm, request.frame.spacing_mm), out_(out) {}

  void write(const RowPoints& rows, int first_row, int end_row) {
    for (int row = first_row; row < end_row; ++row) {
      for (int col = 0; col < rows.cols; ++col) {
        const std::size_t i = frame_.size.index({.col = col, .row = row});
        const CellSpan cell = rows.of(col, col + 1, row);
        out_.quality.counts[i] = static_cast<std::uint32_t>(cell.size());
        const std::optional<double> between = fromAround(rows, col, row);
        if (!out_.between.empty() && between) out_.between[i] = static_cast<float>(*between);
        if (cell.empty()) continue;
        // Of two points one may be the back's; the front-most is the surer one.
        const float top = cell.size() < 3 ? frontMost(cell) : secondLargest(cell);
        const Moments layer = topLayer(cell, top, frame_.spacing_mm);
        out_.quality.spreads_mm[i] = static_cast<float>(layer.deviation());
        out_.front[i] = between ? static_cast<float>(*between) : ownHeight(cell, top, layer);
        if (layer.count < cell.size()) lookBehind(cell, i);
      }
    }
  }

  HiddenSurface hidden() const { return hidden_; }

 private:
  std::optional<double> fromAround(const RowPoints& rows, int col, int row) {
    if (rule_ == PointRule::splat) return splatAt(rows, col, row);
    if (rule_ == PointRule::quadratic) return fit_.heightAt(rows, col, row);
    return std::nullopt;
  }

  float ownHeight(CellSpan cell, float top, const Moments& layer) {
    switch (rule_) {
      case PointRule::second:
        return secondLargest(cell);
      case PointRule::top_mean:
        return static_cast<float>(layer.mean(top));
      case PointRule::median:
        return static_cast<float>(medianOf(cell, scratch_));
      case PointRule::mean:
      case PointRule::splat:
      case PointRule::quadratic: {
        Moments all;
        for (const PlacedPoint& p : cell) all.add(p.z, top);
        return static_cast<float>(all.mean(top));
      }
      case PointRule::front:
        break;
    }
    return frontMost(cell);
  }

  void lookBehind(CellSpan cell, std::size_t index) {
    out_.steep[index] = isWall(cell, frame_.spacing_mm, scratch_) ? 1 : 0;
    const auto limit = static_cast<float>(kHiddenCells * frame_.spacing_mm);
    float low = -kLowest;
    float high = kLowest;
    for (const PlacedPoint& p : cell) {
      if (!(p.z < out_.front[index] - limit)) continue;
      hidden_.hidden += 1;
      low = std::min(low, p.z);
      high = std::max(high, p.z);
    }
    if (low > high) return;
    ++hidden_.cells;
    hidden_.cells_in_layers += high - low > limit ? 1 : 0;
  }

  GridFrame frame_;
  PointRule rule_;
  LocalFit fit_;
  HiddenSurface hidden_;
  CapturedDepths& out_;
  std::vector<float> scratch_;
};

int reachOf(PointRule rule) {
  if (rule == PointRule::quadratic) return LocalFit::kWidest;
  return rule == PointRule::splat ? 1 : 0;
}

}  // namespace

std::optional<PointRule> pointRule(std::string_view name) {
  for (const auto& [known, rule] : kNames) {
    if (known == name) return rule;
  }
  return std::nullopt;
}

std::string_view describe(PointRule rule) {
  switch (rule) {
    case PointRule::second:
      return "second point from the front";
    case PointRule::top_mean:
      return "mean of the top layer";
    case PointRule::median:
      return "median of the points";
    case PointRule::mean:
      return "mean of the points";
    case PointRule::splat:
      return "bilinear splat";
    case PointRule::quadratic:
      return "local quadratic";
    case PointRule::front:
      break;
  }
  return "front-most point";
}

RuleProposal proposeRule(const DepthRequest& request, const Task& task) {
  return propose(CellPoints(request, task), task);
}

double pointNoise(const DepthRequest& request, const Task& task) {
  return noiseOf(CellPoints(request, task), task);
}

CapturedDepths scatterPoints(const DepthRequest& request, const Task& task) {
  const CellPoints points(request, task);
  const RuleProposal rule = request.rule
                                ? RuleProposal{.rule = *request.rule, .reason = "as chosen"}
                                : propose(points, task);
  double noise_mm = request.noise_mm.value_or(0);
  if (!request.noise_mm && rule.rule == PointRule::quadratic) noise_mm = noiseOf(points, task);
  const GridSize size = request.frame.size;
  CapturedDepths out;
  out.rule = rule.reason + ": " + std::string(describe(rule.rule));
  out.front.assign(size.count(), kEmpty);
  out.quality.counts.assign(size.count(), 0);
  out.quality.spreads_mm.assign(size.count(), 0.0F);
  out.steep.assign(size.count(), 0);
  const int reach = reachOf(rule.rule);
  if (reach > 0) out.between.assign(size.count(), kEmpty);

  const int rows_at_once = rowsAtOnce(size);
  const int units = (size.rows + rows_at_once - 1) / rows_at_once;
  std::mutex joining;
  HiddenSurface hidden{.all = static_cast<double>(points.onGrid())};
  std::atomic<int> done = 0;
  inBands(units, points.threads(), [&](int first_unit, int end_unit) {
    RowWriter writer(request, rule.rule, noise_mm, out);
    std::size_t flyers = 0;
    for (int unit = first_unit; unit < end_unit; ++unit) {
      task.check();
      const int first = unit * rows_at_once;
      const int end = std::min(first + rows_at_once, size.rows);
      // More than the rule reaches, so that flyers are known as far as it does.
      RowPoints rows = points.rows(first - reach - kFlyerReach, end + reach + kFlyerReach);
      flyers += dropFlyers(rows, request.frame.spacing_mm, first, end);
      writer.write(rows, first, end);
      ++done;
      if (first_unit == 0) task.report("Depth map", 0.3 + 0.7 * done / units);
    }
    // Whole numbers: the order of the bands does not matter.
    const std::lock_guard lock(joining);
    out.flyers += flyers;
    hidden.hidden += writer.hidden().hidden;
    hidden.cells += writer.hidden().cells;
    hidden.cells_in_layers += writer.hidden().cells_in_layers;
  });
  out.hidden = hidden;
  return out;
}

}  // namespace relievo
