// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <span>
#include <vector>

#include "core/neighbours/point_neighbours.h"
#include "core/prepare/job.h"

namespace relievo::test {

/// A wavy relief of 100 x 100 units, unevenly sampled, with outliers above it.
inline std::vector<Point3f> reliefWithOutliers(std::size_t points, double outliers, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> share(0, 1);
  std::vector<Point3f> cloud;
  for (std::size_t i = 0; i < points; ++i) {
    const float x = 100 * share(random) * std::sqrt(share(random));
    const float y = 100 * share(random);
    const float z = 3 * std::sin(0.2F * x) * std::cos(0.15F * y) + 0.02F * share(random);
    cloud.push_back({x, y, share(random) < static_cast<float>(outliers) ? 40 * share(random) : z});
  }
  return cloud;
}

/// A part of the points is repeated, anywhere in the order.
inline std::vector<Point3f> withDuplicates(std::vector<Point3f> cloud, double part, unsigned seed) {
  std::mt19937 random(seed);
  const auto repeated = static_cast<std::size_t>(part * static_cast<double>(cloud.size()));
  const std::size_t first = cloud.size();
  for (std::size_t i = 0; i < repeated; ++i) cloud.push_back(cloud[random() % first]);
  std::shuffle(cloud.begin(), cloud.end(), random);
  return cloud;
}

inline PrepareScan scanOf(std::span<const Point3f> points) {
  PrepareScan scan;
  scan.name = "made.ply";
  scan.points = points;
  return scan;
}

inline std::vector<std::uint32_t> numbersOf(const PointBits& bits) {
  std::vector<std::uint32_t> numbers;
  for (std::uint32_t i = 0; i < bits.size(); ++i) {
    if (bits[i]) numbers.push_back(i);
  }
  return numbers;
}

}  // namespace relievo::test
