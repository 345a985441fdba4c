// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "core/cloud/scan.h"

namespace relievo {

/// Coordinates beyond it are no measurements; differences of two such numbers are finite in float.
inline constexpr double kFarthestCoordinate = 1e38;

/// Collects what a reader finds, in double, and makes a Scan of it: counts, bounds, an origin near
/// the points (so that floats keep the file's resolution), triangles with valid indices.
class ScanBuilder {
 public:
  /// @throw FileError  from addPoint, when more than max_points come
  ScanBuilder(const std::filesystem::path& file, std::uint64_t max_points)
      : max_points_(max_points) {
    scan_.info.file = file;
  }

  ScanInfo& info() noexcept { return scan_.info; }
  std::uint64_t pointCount() const noexcept { return scan_.info.points; }
  std::uint64_t faceCount() const noexcept { return scan_.info.faces; }
  void expectPoints(std::uint64_t count);  ///< A hint; never trusted beyond max_points.

  /// The next stored point; those that are not finite are counted only.
  void addPoint(double x, double y, double z) {
    // NaN and infinity fail the comparisons. Binary files spend their time here; a call for every
    // point cost 2 to 7 ns more of 11 to 18 (reader_benchmark).
    const bool usable = std::abs(x) <= kFarthestCoordinate && std::abs(y) <= kFarthestCoordinate &&
                        std::abs(z) <= kFarthestCoordinate;
    if (!usable || !origin_chosen_ || scan_.info.points >= max_points_) {
      addSpecialPoint({x, y, z}, usable);
      return;
    }
    ++scan_.info.points;
    extendBox(x, y, z);
    store({x, y, z});
  }

  /// The next stored polygon, corners counted from 0 in stored order; may come before its points.
  void addFace(std::span<const std::int64_t> corners);

  Scan finish();

 private:
  void addSpecialPoint(const std::array<double, 3>& p, bool usable);
  void chooseOrigin();

  void extendBox(double x, double y, double z) noexcept {
    box_.min = {std::min(box_.min.x, x), std::min(box_.min.y, y), std::min(box_.min.z, z)};
    box_.max = {std::max(box_.max.x, x), std::max(box_.max.y, y), std::max(box_.max.z, z)};
  }
  void store(const std::array<double, 3>& p) {
    scan_.points.push_back({static_cast<float>(p[0] - scan_.origin.x),
                            static_cast<float>(p[1] - scan_.origin.y),
                            static_cast<float>(p[2] - scan_.origin.z)});
  }
  void makeTriangles();
  bool triangulate(std::span<const std::uint32_t> corners);

  static constexpr std::size_t kSample = 65536;
  static constexpr double kInfinite = std::numeric_limits<double>::infinity();

  Scan scan_;
  std::uint64_t max_points_;
  bool origin_chosen_ = false;
  FileBounds box_{{kInfinite, kInfinite, kInfinite}, {-kInfinite, -kInfinite, -kInfinite}};
  std::vector<std::array<double, 3>> sample_;  ///< Points that came before the origin was chosen.
  std::vector<std::uint32_t> skipped_;         ///< Stored indices of points left out, ascending.
  std::uint64_t too_far_ = 0;                  ///< Finite in the file, but not in float.
  std::vector<std::uint32_t> corners_;         ///< Of all faces, one after the other.
  std::vector<std::uint32_t> corner_counts_;
};

}  // namespace relievo
