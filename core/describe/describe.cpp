// SPDX-License-Identifier: BSD-3-Clause
#include "core/describe/describe.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/describe/height_grid.h"
#include "core/outline/two_groups.h"
#include "core/session/large/tiled_surface.h"
#include "core/session/map_facts.h"
#include "core/session/surface.h"

namespace relievo {
namespace {

// When a fact is said; docs/adr/0162 says why. A ramp has a separability of 0.75 and no raised
// area.
constexpr double kClear = 0.8;           // Separability.
constexpr double kSmallest = 0.01;       // Of the surface: an area, a gap.
constexpr double kOtherThreshold = 0.1;  // Of the span: as many areas there, too.
constexpr std::size_t kMostAreas = 5;
constexpr double kAsHigh = 0.05;       // Of the span.
constexpr double kOnePlace = 1.0 / 6;  // Of the longer side.
constexpr double kMuchRougher = 3;
constexpr double kRoughAtLeast = 0.002;  // Of the span; below, it is what the grid left.
constexpr int kFewestSamples = 50;       // In a ninth.

bool isMeasured(CellStatus origin) {
  return origin == CellStatus::measured || origin == CellStatus::steep;
}

struct Span {
  float min_mm = 0, max_mm = 0;
  double mm() const { return static_cast<double>(max_mm) - min_mm; }
};

/// Heights of the object, ascending.
std::vector<float> sortedHeights(const HeightGrid& grid) {
  std::vector<float> heights;
  for (int i = 0; i < HeightGrid::kCount; ++i) {
    if (grid.has(i)) heights.push_back(grid.heightMm(i));
  }
  std::sort(heights.begin(), heights.end());
  return heights;
}

double quantile(const std::vector<float>& ascending, double share) {
  return ascending[static_cast<std::size_t>(share * static_cast<double>(ascending.size() - 1))];
}

std::vector<GridArea> areasAbove(const HeightGrid& grid, double height_mm, int surface) {
  std::vector<GridArea> areas =
      grid.areas([&](int i) { return grid.has(i) && grid.heightMm(i) > height_mm; });
  std::erase_if(areas, [&](const GridArea& a) { return a.samples < kSmallest * surface; });
  return areas;
}

RaisedArea raisedArea(const HeightGrid& grid, const GridArea& area, const RectMm& object,
                      int surface) {
  const double step_mm = grid.stepMm();
  RaisedArea raised{.x_mm = grid.xMm(area.col),
                    .y_mm = grid.yMm(area.row),
                    .width_mm = (area.last_col - area.first_col + 1) * step_mm,
                    .height_mm = (area.last_row - area.first_row + 1) * step_mm,
                    .share = static_cast<double>(area.samples) / surface};
  raised.ninth = ninthOf(object, raised.x_mm, raised.y_mm);
  constexpr double kAllRound = 0.95;
  raised.is_rim = raised.width_mm >= kAllRound * object.width_mm &&
                  raised.height_mm >= kAllRound * object.height_mm && !area.has_its_centroid;
  return raised;
}

void findAreas(const HeightGrid& grid, const Span& span, int surface, Description& d) {
  if (d.separability < kClear) return;
  const std::vector<GridArea> areas = areasAbove(grid, d.threshold_mm, surface);
  if (areas.empty() || areas.size() > kMostAreas) return;
  for (const double step : {-kOtherThreshold, kOtherThreshold}) {
    const double other_mm = d.threshold_mm + step * span.mm();
    if (areasAbove(grid, other_mm, surface).size() != areas.size()) return;
  }
  for (const GridArea& area : areas) {
    d.raised.push_back(raisedArea(grid, area, d.object, surface));
  }
}

/// Of what was measured: a filled hole has no highest place.
void findHighest(const HeightGrid& grid, const RegionWindow& whole, const Span& span,
                 Description& d) {
  const double as_high_mm = span.max_mm - kAsHigh * span.mm();
  GridArea all{.first_col = HeightGrid::kSide, .first_row = HeightGrid::kSide};
  for (int i = 0; i < HeightGrid::kCount; ++i) {
    const bool was_seen = isMeasured(whole.origins[static_cast<std::size_t>(i)]);
    if (was_seen && grid.has(i) && grid.heightMm(i) >= as_high_mm) all.add(i);
  }
  if (all.samples == 0) return;
  const double reach_mm = kOnePlace * std::max(d.object.width_mm, d.object.height_mm);
  const int cells = std::max(all.last_col - all.first_col, all.last_row - all.first_row);
  if (cells * grid.stepMm() > reach_mm) return;
  Description::Highest highest{
      // The height that the range says: the finest cells reach above the samples of Detail 1.
      .x_mm = grid.xMm(all.col),
      .y_mm = grid.yMm(all.row),
      .height_mm = d.heights.max_mm};
  highest.ninth = ninthOf(d.object, highest.x_mm, highest.y_mm);
  d.highest = highest;
}

/// Of ninths at least half of which were measured: what fills a hole is smooth.
void findRoughness(const HeightGrid& grid, const RegionWindow& whole, const Span& span,
                   Description& d) {
  // What is left of the neighbourhood's mean is bent as the surface is; what is left of that again
  // is not.
  const HeightGrid bent = grid.without(grid.smoothed());
  const HeightGrid rough = bent.without(bent.smoothed());
  std::array<std::vector<double>, kNinths> off_mm;
  std::array<int, kNinths> filled{};
  for (int i = 0; i < HeightGrid::kCount; ++i) {
    if (!rough.has(i)) continue;
    const Ninth ninth = ninthOf(d.object, grid.xMm(i % HeightGrid::kSide),
                                grid.yMm(i / HeightGrid::kSide));  // NOLINT: rows.
    if (!isMeasured(whole.origins[static_cast<std::size_t>(i)])) {
      ++filled[static_cast<std::size_t>(ninth)];
      continue;
    }
    off_mm[static_cast<std::size_t>(ninth)].push_back(std::abs(rough.heightMm(i)));
  }
  const auto median = [](std::vector<double>& values) {
    const auto half = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), half, values.end());
    return *half;
  };
  std::vector<std::size_t> known;
  for (std::size_t n = 0; n < kNinths; ++n) {
    const auto measured = static_cast<int>(off_mm[n].size());
    const bool few = measured < kFewestSamples || measured < filled[n];
    d.roughness_mm[n] = few ? -1 : median(off_mm[n]);
    if (!few) known.push_back(n);
  }
  if (known.size() < 3) return;
  const auto less = [&](std::size_t a, std::size_t b) {
    return d.roughness_mm[a] < d.roughness_mm[b];
  };
  std::sort(known.begin(), known.end(), less);
  const auto medianWithout = [&](std::size_t left_out) {
    std::vector<double> others;
    for (const std::size_t n : known) {
      if (n != left_out) others.push_back(d.roughness_mm[n]);
    }
    return median(others);
  };
  const std::size_t most = known.back(), least = known.front();
  const double least_mm = kRoughAtLeast * span.mm();
  if (d.roughness_mm[most] >= std::max(kMuchRougher * medianWithout(most), least_mm)) {
    d.roughest = static_cast<Ninth>(most);
  }
  if (medianWithout(least) >= std::max(kMuchRougher * d.roughness_mm[least], least_mm)) {
    d.smoothest = static_cast<Ninth>(least);
  }
}

void findGap(const HeightGrid& grid, const RegionWindow& whole, int surface, Description& d) {
  const auto gaps = grid.areas([&](int i) {
    const CellStatus origin = whole.origins[static_cast<std::size_t>(i)];
    return origin != CellStatus::outside && !isMeasured(origin);
  });
  if (gaps.empty() || gaps.front().samples < kSmallest * surface) return;
  d.largest_gap = ninthOf(d.object, grid.xMm(gaps.front().col), grid.yMm(gaps.front().row));
}

}  // namespace

Description describe(const RegionWindow& whole, const RectMm& object, const HeightRange& heights,
                     const std::array<double, kOriginCount>& shares) {
  Description d;
  d.object = object;
  d.heights = heights;
  const auto share = [&](CellStatus origin) { return shares[static_cast<std::size_t>(origin)]; };
  const double on_object = 1 - share(CellStatus::outside);
  if (on_object > 0) {
    d.not_measured = (share(CellStatus::interpolated) + share(CellStatus::base_plane)) / on_object;
  }
  const HeightGrid grid(whole);
  const std::vector<float> ascending = sortedHeights(grid);
  d.has_heights = !ascending.empty();
  if (!d.has_heights) return d;
  const int surface =
      kWindowSamples * kWindowSamples -
      static_cast<int>(std::count(whole.origins.begin(), whole.origins.end(), CellStatus::outside));
  findGap(grid, whole, surface, d);
  const Span span{ascending.front(), ascending.back()};
  d.most_span_mm = quantile(ascending, 0.98) - quantile(ascending, 0.02);
  constexpr double kFlat = 1e-6;  // Of the side: what single precision leaves of a plane.
  if (span.mm() <= kFlat * whole.region.side_mm) return d;
  findHighest(grid, whole, span, d);
  const TwoGroups groups = partedInTwo(ascending);
  d.threshold_mm = groups.threshold_mm;
  d.separability = groups.separability;
  findAreas(grid, span, surface, d);
  const HeightGrid smooth = grid.smoothed();
  d.mirrored_sides = smooth.mirrored(true);
  d.mirrored_ends = smooth.mirrored(false);
  findRoughness(grid, whole, span, d);
  return d;
}

Description describe(const Surface& surface) {
  const DetailLadder& ladder = surface.ladder;
  const MapFacts facts = mapFacts(surface);
  return describe(windowOf(surface, wholeRegion(ladder)),
                  {ladder.left_mm, ladder.bottom_mm, ladder.width_mm, ladder.height_mm},
                  facts.heights, facts.shares);
}

}  // namespace relievo
