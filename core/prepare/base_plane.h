// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/base/task.h"
#include "core/neighbours/point_neighbours.h"
#include "core/prepare/recipe.h"

namespace relievo {

/// The plane that holds most points.
struct BasePlane {
  std::array<double, 3> normal{};    ///< Unit; most of the other points lie on its side.
  std::array<double, 3> middle{};    ///< Mean of the points on it.
  std::vector<std::uint32_t> on_it;  ///< Numbers of these points, rising.
};

/// Found by pcl::SACSegmentation (RANSAC, one thread, the same result for the same seed), fitted by
/// least squares in double. [worker]
/// @param distance  in the points' unit; nearer is on it
/// @return  nothing if no three points span a plane
std::optional<BasePlane> basePlane(std::span<const Point3f> points, double distance,
                                   std::uint32_t seed, const Task& task);

/// The rotation about the plane's middle that turns its normal to +z, by the shortest way.
Pose layingFlat(const BasePlane& plane, const FilePoint& centre);

}  // namespace relievo
