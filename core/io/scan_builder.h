// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
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
  void addPoint(double x, double y, double z);

  /// The next stored polygon, corners counted from 0 in stored order; may come before its points.
  void addFace(std::span<const std::int64_t> corners);

  Scan finish();

 private:
  void chooseOrigin();
  void store(const std::array<double, 3>& p);
  void makeTriangles();
  bool triangulate(std::span<const std::uint32_t> corners);

  static constexpr std::size_t kSample = 65536;

  Scan scan_;
  std::uint64_t max_points_;
  bool origin_chosen_ = false;
  std::vector<std::array<double, 3>> sample_;  ///< Points that came before the origin was chosen.
  std::vector<std::uint32_t> skipped_;         ///< Stored indices of points left out, ascending.
  std::uint64_t too_far_ = 0;                  ///< Finite in the file, but not in float.
  std::vector<std::uint32_t> corners_;         ///< Of all faces, one after the other.
  std::vector<std::uint32_t> corner_counts_;
};

}  // namespace relievo
