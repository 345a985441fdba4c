// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "core/base/task.h"
#include "core/neighbours/point_neighbours.h"

namespace relievo {

/// For every point a unit normal: of the plane through its `count` nearest places, by least
/// squares, turned toward `viewpoint`, else away from the middle of all places. 0 0 0 where no
/// plane is seen: fewer than three places, or all on a line. [worker]
/// @param points  how many the neighbours were made of  @throw Cancelled
std::vector<Point3f> normalsOf(const PointNeighbours& neighbours, std::size_t points, int count,
                               const std::optional<Point3f>& viewpoint, const Task& task);

}  // namespace relievo
