// SPDX-License-Identifier: BSD-3-Clause
#include "core/depth/rules/point_rule.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <limits>
#include <mutex>
#include <utility>
#include <vector>

#include "core/base/bands.h"
#include "core/base/large_pages.h"
#include "core/depth/layers/outliers.h"
#include "core/depth/rules/cell_points.h"
#include "core/depth/rules/local_fit.h"
#include "core/depth/rules/row_fits.h"
#include "core/depth/rules/row_splats.h"
#include "core/depth/rules/rule_choice.h"
#include "core/message/catalogue.h"

namespace relievo {
namespace {

constexpr float kEmpty = std::numeric_limits<float>::quiet_NaN();
constexpr float kLowest = -std::numeric_limits<float>::infinity();
constexpr int kRowsBetweenChecks = 4;   // Of a wide grid, a few milliseconds.
constexpr int kFitsAtOnce = 256;        // Columns: their sums take 300 kB.
constexpr double kTopLayerCells = 1.5;  // Depth of the top layer: slopes up to 56 degrees.

constexpr std::array<std::pair<std::string_view, PointRule>, 8> kNames{
    {{"front", PointRule::front},
     {"second", PointRule::second},
     {"topmean", PointRule::top_mean},
     {"median", PointRule::median},
     {"mean", PointRule::mean},
     {"splat", PointRule::splat},
     {"quadratic", PointRule::quadratic},
     {"min", PointRule::lowest}}};

using CellSpan = std::span<const PlacedPoint>;

float frontMost(CellSpan cell) {
  float highest = kLowest;
  for (const PlacedPoint& p : cell) highest = std::max(highest, p.z);
  return highest;
}

float rearMost(CellSpan cell) {
  float lowest = -kLowest;
  for (const PlacedPoint& p : cell) lowest = std::min(lowest, p.z);
  return lowest;
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

CellRange countedBy(const DepthRequest& request) {
  const GridSize size = request.frame.size;
  return request.counted.value_or(
      CellRange{.first = {}, .end = {.col = size.cols, .row = size.rows}});
}

/// Writes the cells of some rows.
class RowWriter {
 public:
  RowWriter(const DepthRequest& request, PointRule rule, double noise_mm, CapturedDepths& out,
            const Task& task)
      : frame_(request.frame),
        rule_(rule),
        fit_(noise_mm, request.frame.spacing_mm),
        counted_(countedBy(request)),
        out_(out),
        task_(task) {}

  void write(const RowPoints& rows, int first_row, int end_row) {
    if (rule_ == PointRule::splat) splats_.compute(rows, first_row, end_row);
    const int cols_at_once = rule_ == PointRule::quadratic ? kFitsAtOnce : rows.cols;
    for (int first_col = 0; first_col < rows.cols; first_col += cols_at_once) {
      const int end_col = std::min(first_col + cols_at_once, rows.cols);
      for (int row = first_row; row < end_row; ++row) {
        if (row % kRowsBetweenChecks == 0) task_.check();
        if (rule_ == PointRule::quadratic) {
          row_fits_.compute(rows, row, first_col, end_col, row == first_row);
        }
        writeRow(rows, row, first_col, end_col);
      }
    }
  }

  HiddenSurface hidden() const { return hidden_; }

 private:
  void writeRow(const RowPoints& rows, int row, int first_col, int end_col) {
    for (int col = first_col; col < end_col; ++col) {
      const std::size_t i = frame_.size.index({.col = col, .row = row});
      const CellSpan cell = rows.of(col, col + 1, row);
      out_.quality.counts[i] = static_cast<std::uint32_t>(cell.size());
      const std::optional<double> between = fromAround(rows, col, row);
      if (!out_.between.empty() && between) out_.between[i] = static_cast<float>(*between);
      if (cell.empty()) continue;
      if (cell.size() == 1) {  // Its height by any rule, no spread, and nothing behind it.
        out_.front[i] = between ? static_cast<float>(*between) : cell[0].z;
        continue;
      }
      // Of two points one may be the back's; the front-most is the surer one.
      const float top = cell.size() < 3 ? frontMost(cell) : secondLargest(cell);
      const Moments layer = topLayer(cell, top, frame_.spacing_mm);
      out_.quality.spreads_mm[i] = static_cast<float>(layer.deviation());
      out_.front[i] = between ? static_cast<float>(*between) : ownHeight(cell, top, layer);
      if (layer.count < cell.size()) lookBehind(cell, {.col = col, .row = row});
    }
  }

  std::optional<double> fromAround(const RowPoints& rows, int col, int row) {
    if (rule_ == PointRule::splat) return splats_.at(col, row);
    if (rule_ == PointRule::quadratic) {
      const bool smooth = row_fits_.fitted(col) && row_fits_.rmsMm(col) <= fit_.allowedMm();
      return smooth ? row_fits_.heightMm(col) : fit_.heightAt(rows, col, row);
    }
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
      case PointRule::lowest:
        return rearMost(cell);
      case PointRule::front:
        break;
    }
    return frontMost(cell);
  }

  void lookBehind(CellSpan cell, Cell place) {
    const std::size_t index = frame_.size.index(place);
    out_.steep[index] = isWall(cell, frame_.spacing_mm, scratch_) ? 1 : 0;
    if (!contains(counted_, place)) return;
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
  RowFits row_fits_;
  RowSplats splats_;
  CellRange counted_;
  HiddenSurface hidden_;
  CapturedDepths& out_;
  const Task& task_;
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

Message ruleMessage(PointRule rule) {
  switch (rule) {
    case PointRule::second:
      return said<MessageId::rule_second>();
    case PointRule::top_mean:
      return said<MessageId::rule_top_mean>();
    case PointRule::median:
      return said<MessageId::rule_median>();
    case PointRule::mean:
      return said<MessageId::rule_mean>();
    case PointRule::splat:
      return said<MessageId::rule_splat>();
    case PointRule::quadratic:
      return said<MessageId::rule_quadratic>();
    case PointRule::lowest:
      return said<MessageId::rule_lowest>();
    case PointRule::front:
      break;
  }
  return said<MessageId::rule_front>();
}

std::string_view describe(PointRule rule) {
  return rowOf(ruleMessage(rule).id).screen;
}

Message ruleAndWhy(const RuleProposal& proposal) {
  return said<MessageId::rule_and_why>(proposal.reason, ruleMessage(proposal.rule));
}

bool isForOneLayer(PointRule rule) {
  return rule == PointRule::quadratic || rule == PointRule::median;
}

bool mixesLayers(PointRule rule) {
  return isForOneLayer(rule) || rule == PointRule::mean || rule == PointRule::splat ||
         rule == PointRule::lowest;
}

namespace {

/// Scatters with one rule, a slab of the grid at a time, so that the points sorted by cell never
/// need more than a bounded memory beside the scan.
class Scatter {
 public:
  Scatter(const DepthRequest& request, const Task& task) : request_(request), task_(task) {
    const GridSize size = request.frame.size;
    reserveLarge(out_.front, size.count());
    reserveLarge(out_.quality.counts, size.count());
    reserveLarge(out_.quality.spreads_mm, size.count());
    out_.front.assign(size.count(), kEmpty);
    out_.quality.counts.assign(size.count(), 0);
    out_.quality.spreads_mm.assign(size.count(), 0.0F);
    out_.steep.assign(size.count(), 0);
    hidden_.all = 0;
  }

  CapturedDepths run() {
    const GridSize size = request_.frame.size;
    const std::size_t slabs = request_.scan.points.size() / kPointsAtOnce + 1;
    std::optional<CellPoints> points;
    if (slabs == 1) {
      points.emplace(request_, std::array{RowRange{.first = 0, .end = size.rows}}, task_);
      chooseRule(*points);
    } else {
      chooseRule(CellPoints(request_, rowsOfSamples(size), task_));
    }
    const int rows_at_once = rowsAtOnce(size);
    const int units = (size.rows + rows_at_once - 1) / rows_at_once;
    for (std::size_t slab = 0; slab < slabs; ++slab) {
      const auto unit = [&](std::size_t k) {
        return static_cast<int>(static_cast<std::size_t>(units) * k / slabs);
      };
      const RowRange range{.first = unit(slab) * rows_at_once,
                           .end = std::min(unit(slab + 1) * rows_at_once, size.rows)};
      if (slabs > 1) {
        points = CellPoints(request_, std::array{widened(range, halo())}, task_,
                            points ? &*points : nullptr);
      }
      task_.report("Depth map", static_cast<double>(slab) / static_cast<double>(slabs));
      write(*points, range);
    }
    out_.hidden = hidden_;
    return std::move(out_);
  }

 private:
  int halo() const { return reachOf(rule_) + kOutlierReach; }

  void chooseRule(const CellPoints& points) {
    RuleProposal rule{.rule = request_.rule.value_or(PointRule::front),
                      .reason = said<MessageId::rule_as_chosen>()};
    const bool needs_noise = !request_.noise_mm && rule.rule == PointRule::quadratic;
    const int threads = threadsFor(points.count(), request_.threads);
    std::vector<RowSample> samples;
    if (!request_.rule || needs_noise) {
      samples = samplesOf(points, request_.frame, threads, task_);
    }
    if (!request_.rule) rule = proposeRule(samples, request_.frame, threads, task_);
    rule_ = rule.rule;
    out_.rule = ruleAndWhy(rule);
    out_.one_layer = !request_.rule && isForOneLayer(rule_);
    if (rule_ == PointRule::quadratic) {
      noise_mm_ = request_.noise_mm ? *request_.noise_mm
                                    : pointNoise(samples, request_.frame, threads, task_);
    }
    if (reachOf(rule_) > 0) out_.between.assign(out_.front.size(), kEmpty);
  }

  void write(const CellPoints& points, RowRange slab) {
    const int rows_at_once = rowsAtOnce(request_.frame.size);
    const int units = (slab.end - slab.first + rows_at_once - 1) / rows_at_once;
    const int threads = threadsFor(points.count() + out_.front.size(), request_.threads);
    parallelFor(units, threads, [&](int first_unit, int end_unit) {
      RowWriter writer(request_, rule_, noise_mm_, out_, task_);
      RowPoints rows;
      std::size_t outliers = 0;
      std::size_t on_grid = 0;
      for (int unit = first_unit; unit < end_unit; ++unit) {
        task_.check();
        const int first = slab.first + unit * rows_at_once;
        const int end = std::min(first + rows_at_once, slab.end);
        // More than the rule reaches, so that outliers are known as far as it does.
        points.rows(first - halo(), end + halo(), rows);
        CellRange counted = countedBy(request_);
        counted.first.row = std::max(counted.first.row, first);
        counted.end.row = std::min(counted.end.row, end);
        for (int row = counted.first.row; row < counted.end.row; ++row) {
          on_grid += rows.count(counted.first.col, counted.end.col, row);
        }
        outliers += dropOutliers(rows, request_.frame.spacing_mm, counted);
        writer.write(rows, first, end);
      }
      // Whole numbers: the order of the bands does not matter.
      const std::lock_guard lock(joining_);
      out_.outliers += outliers;
      hidden_.all += static_cast<double>(on_grid);
      hidden_.hidden += writer.hidden().hidden;
      hidden_.cells += writer.hidden().cells;
      hidden_.cells_in_layers += writer.hidden().cells_in_layers;
    });
  }

  // 16 bytes each: 416 MB beside the scan.
  static constexpr std::size_t kPointsAtOnce = 26'000'000;

  const DepthRequest& request_;
  const Task& task_;
  PointRule rule_ = PointRule::front;
  double noise_mm_ = 0;
  CapturedDepths out_;
  HiddenSurface hidden_;
  std::mutex joining_;
};

}  // namespace

CapturedDepths scatterPoints(const DepthRequest& request, const Task& task) {
  return Scatter(request, task).run();
}

}  // namespace relievo
