// SPDX-License-Identifier: BSD-3-Clause
#include "core/outline/outline.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "core/base/line_corners.h"
#include "core/outline/level_lines.h"
#include "core/outline/two_groups.h"

namespace relievo {
namespace {

constexpr int kSide = kWindowSamples;
constexpr int kLevels = 23;
constexpr double kLowest = 0.05, kHighest = 0.98;  // Of all heights, in order.
// As for the areas of a description (docs/adr/0162): so few, and as many at other thresholds.
constexpr std::size_t kMostLines = 5;
constexpr double kOtherThreshold = 0.1;  // Of the span.

using Line = std::vector<SamplePlace>;

bool wasSeen(CellStatus origin) {
  return origin == CellStatus::measured || origin == CellStatus::steep;
}

/// The means of 3 x 3 heights of a window, of those that were seen.
Samples smoothHeights(const RegionWindow& window) {
  Samples samples{.cols = kSide,
                  .rows = kSide,
                  .values = std::vector<double>(kWindowCount),
                  .has = std::vector<bool>(kWindowCount)};
  for (int row = 0; row < kSide; ++row) {
    for (int col = 0; col < kSide; ++col) {
      const std::size_t here = samples.at(col, row);
      samples.has[here] = wasSeen(window.origins[here]);
      if (!samples.has[here]) continue;
      double sum = 0;
      int count = 0;
      for (int r = std::max(0, row - 1); r <= std::min(kSide - 1, row + 1); ++r) {
        for (int c = std::max(0, col - 1); c <= std::min(kSide - 1, col + 1); ++c) {
          const std::size_t i = samples.at(c, r);
          if (!wasSeen(window.origins[i])) continue;
          sum += window.heights_mm[i];
          ++count;
        }
      }
      samples.values[here] = sum / count;
    }
  }
  return samples;
}

std::vector<float> orderedPipeline(const Samples& samples) {
  std::vector<float> heights;
  for (std::size_t i = 0; i < samples.values.size(); ++i) {
    if (samples.has[i]) heights.push_back(static_cast<float>(samples.values[i]));
  }
  std::sort(heights.begin(), heights.end());
  return heights;
}

/// Closed lines that enclose enough, the largest first.
std::vector<Line> linesAt(const Samples& samples, double level) {
  std::vector<Line> lines = closedLevelLines(samples, level);
  constexpr double kLeast = kLeastOutlineShare * kSide * kSide;
  std::erase_if(lines, [](const Line& line) { return std::abs(signedArea(line)) < kLeast; });
  std::stable_sort(lines.begin(), lines.end(), [](const Line& a, const Line& b) {
    return std::abs(signedArea(a)) > std::abs(signedArea(b));
  });
  return lines;
}

/// Slope of the cell in which a place lies, per sample.
double slopeAt(const Samples& samples, double col, double row) {
  const int c = std::clamp(static_cast<int>(col), 0, samples.cols - 2);
  const int r = std::clamp(static_cast<int>(row), 0, samples.rows - 2);
  const double bl = samples.values[samples.at(c, r)], br = samples.values[samples.at(c + 1, r)];
  const double tl = samples.values[samples.at(c, r + 1)];
  const double tr = samples.values[samples.at(c + 1, r + 1)];
  return std::hypot((br - bl + tr - tl) / 2, (tl - bl + tr - br) / 2);
}

/// The mean slope along lines.
double steepness(const Samples& samples, const std::vector<Line>& lines) {
  double sum = 0, length = 0;
  for (const Line& line : lines) {
    for (std::size_t i = 0; i < line.size(); ++i) {
      const SamplePlace& a = line[i];
      const SamplePlace& b = line[(i + 1) % line.size()];
      const double way = std::hypot(b.col - a.col, b.row - a.row);
      sum += way * slopeAt(samples, (a.col + b.col) / 2, (a.row + b.row) / 2);
      length += way;
    }
  }
  return length > 0 ? sum / length : 0;
}

/// Height at a place, of the samples around it that belong to the object.
double heightAt(const RegionWindow& window, const SamplePlace& place) {
  const double col = std::clamp(place.col, 0.0, kSide - 1.0);
  const double row = std::clamp(place.row, 0.0, kSide - 1.0);
  const int c = std::min(static_cast<int>(col), kSide - 2);
  const int r = std::min(static_cast<int>(row), kSide - 2);
  double sum = 0, weights = 0;
  for (int k = 0; k < 4; ++k) {
    const int dc = k % 2, dr = k / 2;  // NOLINT: two by two.
    const auto i = static_cast<std::size_t>(r + dr) * kSide + static_cast<std::size_t>(c + dc);
    if (window.origins[i] == CellStatus::outside) continue;
    // A place on the border has weight on the object's side alone.
    const double weight =
        std::max(1e-9, (1 - std::abs(col - (c + dc))) * (1 - std::abs(row - (r + dr))));
    sum += weight * window.heights_mm[i];
    weights += weight;
  }
  return weights > 0 ? sum / weights : 0;
}

/// The heights along a line, each the mean of some beside it: at a wall one sample more or less is
/// all of its height.
std::vector<double> smoothHeights(const RegionWindow& window, const Line& line) {
  constexpr std::size_t kBeside = 4;
  std::vector<double> heights(line.size()), means(line.size());
  std::transform(line.begin(), line.end(), heights.begin(),
                 [&](const SamplePlace& place) { return heightAt(window, place); });
  for (std::size_t i = 0; i < line.size(); ++i) {
    double sum = 0;
    for (std::size_t k = 0; k <= 2 * kBeside; ++k) {
      sum += heights[(i + k + line.size() - kBeside % line.size()) % line.size()];
    }
    means[i] = sum / (2 * kBeside + 1);
  }
  return means;
}

Outline outlineFrom(const RegionWindow& window, const Line& line,
                    const std::vector<double>& heights_mm, double tolerance_mm) {
  const double step_mm = window.spacingMm();
  std::vector<ViewMm> points;
  for (std::size_t i = 0; i < line.size(); ++i) {
    points.push_back({window.region.x_mm + (line[i].col + 0.5) * step_mm,
                      window.region.y_mm + (line[i].row + 0.5) * step_mm, heights_mm[i]});
  }
  Outline outline;
  for (const std::size_t i : lineCorners(std::span<const ViewMm>(points), true, tolerance_mm)) {
    outline.corners.push_back(points[i]);
  }
  outline.share = std::abs(signedArea(line)) / (kSide * kSide);
  return outline;
}

}  // namespace

double Outline::lengthMm() const {
  double length = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    length += norm(corners[(i + 1) % corners.size()] - corners[i]);
  }
  return length;
}

std::vector<Outline> raisedOutlines(const RegionWindow& window, double tolerance_mm) {
  const Samples samples = smoothHeights(window);
  const std::vector<float> heights = orderedPipeline(samples);
  const TwoGroups groups = partedInTwo(heights);
  if (groups.separability <= 0) return {};
  double level_mm = groups.threshold_mm;
  std::vector<Line> lines = linesAt(samples, level_mm);
  const std::size_t count = lines.size();
  if (count == 0 || count > kMostLines) return {};
  const double other_mm = kOtherThreshold * (static_cast<double>(heights.back()) - heights[0]);
  for (const double other : {level_mm - other_mm, level_mm + other_mm}) {
    if (linesAt(samples, other).size() != count) return {};
  }
  double steepest = steepness(samples, lines);
  const auto quantile = [&](double share) {
    return static_cast<double>(
        heights[static_cast<std::size_t>(share * static_cast<double>(heights.size() - 1))]);
  };
  const double low = quantile(kLowest), high = quantile(kHighest);
  for (int k = 1; k <= kLevels; ++k) {
    const double level = low + (high - low) * k / (kLevels + 1);
    std::vector<Line> here = linesAt(samples, level);
    const double steep = here.size() == count ? steepness(samples, here) : 0;
    if (steep <= steepest) continue;
    steepest = steep;
    level_mm = level;
    lines = std::move(here);
  }
  std::vector<Outline> outlines;
  for (const Line& line : lines) {
    // A level line has one height; that of the samples beside it at a wall is anything.
    Outline outline =
        outlineFrom(window, line, std::vector<double>(line.size(), level_mm), tolerance_mm);
    outline.of = signedArea(line) > 0 ? OutlineOf::raised : OutlineOf::sunk;
    outline.level_mm = level_mm;
    outlines.push_back(std::move(outline));
  }
  return outlines;
}

std::vector<Outline> objectOutlines(const RegionWindow& window, std::uint8_t edges,
                                    double tolerance_mm) {
  // One more sample all round: outside, where the map ends with the window.
  constexpr int kPadded = kSide + 2;
  constexpr std::uint8_t kLeftEdge = 1, kRightEdge = 2, kLowerEdge = 4, kUpperEdge = 8;
  constexpr auto kCount = static_cast<std::size_t>(kPadded) * kPadded;
  Samples samples{.cols = kPadded,
                  .rows = kPadded,
                  .values = std::vector<double>(kCount, 0),
                  .has = std::vector<bool>(kCount, true)};
  const auto open = [&](int col, int row) { samples.has[samples.at(col, row)] = false; };
  for (int i = 0; i < kPadded; ++i) {
    if ((edges & kLeftEdge) == 0) open(0, i);
    if ((edges & kRightEdge) == 0) open(kPadded - 1, i);
    if ((edges & kLowerEdge) == 0) open(i, 0);
    if ((edges & kUpperEdge) == 0) open(i, kPadded - 1);
  }
  for (int row = 0; row < kSide; ++row) {
    for (int col = 0; col < kSide; ++col) {
      const bool is_outside =
          window.origins[static_cast<std::size_t>(row) * kSide + static_cast<std::size_t>(col)] ==
          CellStatus::outside;
      samples.values[samples.at(col + 1, row + 1)] = is_outside ? 0 : 1;
    }
  }
  std::vector<Outline> outlines;
  for (Line& line : linesAt(samples, 0.5)) {
    for (SamplePlace& place : line) place = {place.col - 1, place.row - 1};
    Outline outline = outlineFrom(window, line, smoothHeights(window, line), tolerance_mm);
    outline.of = OutlineOf::object;
    outlines.push_back(std::move(outline));
  }
  return outlines;
}

std::vector<Outline> outlinesOf(const RegionWindow& window, std::uint8_t edges,
                                double tolerance_mm) {
  std::vector<Outline> all = raisedOutlines(window, tolerance_mm);
  for (Outline& outline : objectOutlines(window, edges, tolerance_mm)) {
    all.push_back(std::move(outline));
  }
  return all;
}

const Outline* nearestOutline(const std::vector<Outline>& outlines, double x_mm, double y_mm) {
  const Outline* nearest = nullptr;
  double least = std::numeric_limits<double>::infinity();
  const auto flat = [](const ViewMm& p) { return ViewMm{p.x, p.y, 0}; };
  for (const Outline& outline : outlines) {
    const std::size_t count = outline.corners.size();
    for (std::size_t i = 0; i < count; ++i) {
      const double away = distanceFromStretch(ViewMm{x_mm, y_mm, 0}, flat(outline.corners[i]),
                                              flat(outline.corners[(i + 1) % count]));
      if (away >= least) continue;
      least = away;
      nearest = &outline;
    }
  }
  return nearest;
}

}  // namespace relievo
