// SPDX-License-Identifier: BSD-3-Clause
#include "core/io/scan_builder.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "core/base/large_pages.h"
#include "core/io/file_check.h"

namespace relievo {
namespace {

constexpr std::uint32_t kNoPoint = std::numeric_limits<std::uint32_t>::max();

double medianOf(std::vector<double>& numbers) {
  const auto middle = numbers.begin() + static_cast<std::ptrdiff_t>(numbers.size() / 2);
  std::nth_element(numbers.begin(), middle, numbers.end());
  return *middle;
}

/// 0 where the coordinates are about as large as they are spread, so that floats of the file stay
/// as they are; else their median. Medians, because a few flyers cannot move them.
double originOf(std::vector<double>& coordinates) {
  const double middle = medianOf(coordinates);
  for (double& c : coordinates) c = std::abs(c - middle);
  // Evenly spread coordinates from 0 to L have the median L/2 and the deviation L/4.
  return std::abs(middle) <= 3 * medianOf(coordinates) ? 0 : middle;
}

}  // namespace

void ScanBuilder::expectPoints(std::uint64_t count) {
  reserveLarge(scan_.points, static_cast<std::size_t>(std::min(count, max_points_)));
}

void ScanBuilder::addSpecialPoint(const std::array<double, 3>& p, bool usable) {
  ScanInfo& info = scan_.info;
  if (info.points >= max_points_) {
    throw FileError("Cannot read " + shownName(info.file) + ": it holds more than " +
                    grouped(max_points_) +
                    " points, the limit. Thin it out or cut it into parts first.");
  }
  ++info.points;
  if (!usable) {
    skipped_.push_back(static_cast<std::uint32_t>(info.points - 1));
    const bool finite = std::all_of(p.begin(), p.end(), [](double v) { return std::isfinite(v); });
    if (finite) ++too_far_;
    return;
  }
  extendBox(p[0], p[1], p[2]);
  sample_.push_back(p);
  if (sample_.size() >= kSample) chooseOrigin();
}

void ScanBuilder::chooseOrigin() {
  origin_chosen_ = true;
  if (sample_.empty()) return;
  std::array<double, 3> origin{};
  std::vector<double> axis(sample_.size());
  for (std::size_t i = 0; i < 3; ++i) {
    std::transform(sample_.begin(), sample_.end(), axis.begin(),
                   [i](const std::array<double, 3>& p) { return p[i]; });
    origin[i] = originOf(axis);
  }
  scan_.origin = {origin[0], origin[1], origin[2]};
  for (const std::array<double, 3>& p : sample_) store(p);
  sample_ = {};
}

void ScanBuilder::addFace(std::span<const std::int64_t> corners) {
  ++scan_.info.faces;
  corner_counts_.push_back(static_cast<std::uint32_t>(corners.size()));
  for (const std::int64_t corner : corners) {
    const bool possible = corner >= 0 && corner < static_cast<std::int64_t>(kNoPoint);
    corners_.push_back(possible ? static_cast<std::uint32_t>(corner) : kNoPoint);
  }
}

bool ScanBuilder::triangulate(std::span<const std::uint32_t> corners) {
  if (corners.size() < 3) return false;
  std::vector<std::uint32_t> kept;
  kept.reserve(corners.size());
  for (const std::uint32_t stored : corners) {
    if (stored >= scan_.info.points) return false;
    const auto before = std::lower_bound(skipped_.begin(), skipped_.end(), stored);
    if (before != skipped_.end() && *before == stored) return false;
    kept.push_back(stored - static_cast<std::uint32_t>(before - skipped_.begin()));
  }
  for (std::size_t i = 2; i < kept.size(); ++i) {
    // A triangle with a corner twice has no area and hides nothing.
    if (kept[0] == kept[i - 1] || kept[0] == kept[i] || kept[i - 1] == kept[i]) continue;
    scan_.triangles.push_back({kept[0], kept[i - 1], kept[i]});
  }
  return true;
}

void ScanBuilder::makeTriangles() {
  std::size_t start = 0;
  for (const std::uint32_t count : corner_counts_) {
    if (!triangulate(std::span(corners_).subspan(start, count))) ++scan_.info.dropped_faces;
    start += count;
  }
}

Scan ScanBuilder::finish() {
  if (!origin_chosen_) chooseOrigin();
  makeTriangles();
  ScanInfo& info = scan_.info;
  info.finite_points = scan_.points.size();
  if (info.finite_points > 0) info.bounds = box_;
  if (info.dropped_faces > 0) {
    info.warnings.push_back(grouped(info.dropped_faces) + " of " + grouped(info.faces) +
                            " faces were left out: they name points that are not there or not "
                            "finite, or have fewer than three corners.");
  }
  if (too_far_ > 0) {
    info.warnings.push_back(grouped(too_far_) +
                            " points beyond 1e38 were left out; they are no measurements.");
  }
  if (info.finite_points == 0) {
    throw FileError("Cannot read " + shownName(info.file) + ": it has " + grouped(info.points) +
                    " points, none finite. Choose another file.");
  }
  if (info.bounds->min == info.bounds->max) {
    info.warnings.emplace_back(info.finite_points == 1 ? "The scan has one point only."
                                                       : "All points are the same.");
  }
  return std::move(scan_);
}

}  // namespace relievo
