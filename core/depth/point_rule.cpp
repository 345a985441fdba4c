// SPDX-License-Identifier: BSD-3-Clause
#include "core/depth/point_rule.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <utility>
#include <vector>

#include "core/depth/grid_points.h"

namespace relievo {
namespace {

constexpr float kEmpty = std::numeric_limits<float>::quiet_NaN();
constexpr float kLowest = -std::numeric_limits<float>::infinity();
constexpr double kEnoughToAverage = 4;      // Points a cell.
constexpr double kTopLayerCells = 1.5;      // Depth of the top layer: slopes up to 56 degrees.
constexpr double kOtherLayerCells = 4;      // Points this far apart are not one surface.
constexpr double kMostLayeredShare = 0.05;  // Flyers and walls put that many cells apart.

constexpr std::array<std::pair<std::string_view, PointRule>, 5> kNames{
    {{"front", PointRule::front},
     {"second", PointRule::second},
     {"topmean", PointRule::top_mean},
     {"median", PointRule::median},
     {"mean", PointRule::mean}}};

FrontDepths frontMost(const DepthRequest& request, const Task& task) {
  FrontDepths depths(request.frame.size.count(), kEmpty);
  forEachPoint(request, task, [&](std::size_t cell, double z) {
    const auto height = static_cast<float>(z);
    // Also true where the cell is still NaN.
    if (!(depths[cell] >= height)) depths[cell] = height;
  });
  return depths;
}

/// Second largest, or the only one.
FrontDepths secondLargest(const DepthRequest& request, const Task& task) {
  struct Top {
    float first = kLowest, second = kLowest;
  };
  std::vector<Top> tops(request.frame.size.count());
  forEachPoint(request, task, [&](std::size_t cell, double z) {
    Top& top = tops[cell];
    const auto height = static_cast<float>(z);
    if (height > top.first) {
      top.second = std::exchange(top.first, height);
    } else {
      top.second = std::max(top.second, height);
    }
  });
  FrontDepths depths(tops.size(), kEmpty);
  for (std::size_t i = 0; i < tops.size(); ++i) {
    if (tops[i].first > kLowest) {
      depths[i] = tops[i].second > kLowest ? tops[i].second : tops[i].first;
    }
  }
  return depths;
}

/// Mean of the points that `takes(cell, z)`.
template <class Takes>
FrontDepths meanOf(const DepthRequest& request, const Task& task, Takes&& takes) {
  struct Sum {
    double z = 0;
    std::uint32_t count = 0;
  };
  std::vector<Sum> sums(request.frame.size.count());
  forEachPoint(request, task, [&](std::size_t cell, double z) {
    if (!takes(cell, z)) return;
    sums[cell].z += z;
    ++sums[cell].count;
  });
  FrontDepths depths(sums.size(), kEmpty);
  for (std::size_t i = 0; i < sums.size(); ++i) {
    if (sums[i].count > 0) depths[i] = static_cast<float>(sums[i].z / sums[i].count);
  }
  return depths;
}

/// The second largest stands for the top, so that one flyer above the surface is not it; the mean
/// is over what lies within a small depth of it, either way.
FrontDepths topMean(const DepthRequest& request, const Task& task) {
  const FrontDepths tops = secondLargest(request, task);
  const double depth = kTopLayerCells * request.frame.spacing_mm;
  return meanOf(request, task, [&](std::size_t cell, double z) {
    return std::abs(z - static_cast<double>(tops[cell])) <= depth;
  });
}

double medianOf(float* begin, float* end) {
  const auto count = end - begin;
  float* middle = begin + count / 2;
  std::nth_element(begin, middle, end);
  const auto upper = static_cast<double>(*middle);
  if (count % 2 == 1) return upper;
  return 0.5 * (upper + static_cast<double>(*std::max_element(begin, middle)));
}

/// All points, sorted into their cells by counting.
FrontDepths medians(const DepthRequest& request, const Task& task) {
  std::vector<std::size_t> end(request.frame.size.count() + 1, 0);
  forEachPoint(request, task, [&](std::size_t cell, double) { ++end[cell + 1]; });
  for (std::size_t i = 1; i < end.size(); ++i) end[i] += end[i - 1];
  std::vector<float> heights(end.back());
  // end[cell] is the cell's first place, and moves to its end while the points come in.
  forEachPoint(request, task,
               [&](std::size_t cell, double z) { heights[end[cell]++] = static_cast<float>(z); });
  FrontDepths depths(request.frame.size.count(), kEmpty);
  std::size_t first = 0;
  for (std::size_t i = 0; i < depths.size(); ++i) {
    if (i % (1U << 16U) == 0) task.check();
    if (end[i] > first) {
      depths[i] = static_cast<float>(medianOf(heights.data() + first, heights.data() + end[i]));
    }
    first = end[i];
  }
  return depths;
}

struct Occupancy {
  double points_per_cell = 0;  ///< Over the cells with points.
  double layered_share = 0;    ///< Of these, with points far apart in depth.
};

Occupancy occupancy(const DepthRequest& request, const Task& task) {
  struct Range {
    float low = std::numeric_limits<float>::infinity();
    float high = kLowest;
  };
  std::vector<Range> ranges(request.frame.size.count());
  std::size_t points = 0;
  forEachPoint(request, task, [&](std::size_t cell, double z) {
    Range& range = ranges[cell];
    range.low = std::min(range.low, static_cast<float>(z));
    range.high = std::max(range.high, static_cast<float>(z));
    ++points;
  });
  const auto apart = static_cast<float>(kOtherLayerCells * request.frame.spacing_mm);
  std::size_t occupied = 0;
  std::size_t layered = 0;
  for (const Range& range : ranges) {
    if (range.high < range.low) continue;
    ++occupied;
    layered += range.high - range.low > apart ? 1 : 0;
  }
  if (occupied == 0) return {};
  const auto cells = static_cast<double>(occupied);
  return {.points_per_cell = static_cast<double>(points) / cells,
          .layered_share = static_cast<double>(layered) / cells};
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
    case PointRule::front:
      break;
  }
  return "front-most point";
}

RuleProposal proposeRule(const DepthRequest& request, const Task& task) {
  const Occupancy found = occupancy(request, task);
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.1f points per cell", found.points_per_cell);
  RuleProposal proposal{.rule = PointRule::front, .reason = text.data()};
  if (found.points_per_cell < kEnoughToAverage) return proposal;
  const bool layered = found.layered_share > kMostLayeredShare;
  proposal.rule = layered ? PointRule::top_mean : PointRule::median;
  proposal.reason += layered ? " in several layers" : " in one layer";
  return proposal;
}

FrontDepths scatterPoints(const DepthRequest& request, const Task& task) {
  switch (request.rule) {
    case PointRule::second:
      return secondLargest(request, task);
    case PointRule::top_mean:
      return topMean(request, task);
    case PointRule::median:
      return medians(request, task);
    case PointRule::mean:
      return meanOf(request, task, [](std::size_t, double) { return true; });
    case PointRule::front:
      break;
  }
  return frontMost(request, task);
}

}  // namespace relievo
