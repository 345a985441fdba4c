// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/task.h"
#include "core/neighbours/point_neighbours.h"

namespace relievo {

/// Most points that withoutOffSurface leaves out: where more stand out, as on edges and in leaves,
/// that is what the surface is like.
inline constexpr double kMostOffSurface = 0.0018;

/// Numbers of the points that stay, rising: all but those that lie more than so many times as far
/// from the plane of their 12 nearest places as most of these from theirs. Less than a twentieth
/// of the mean distance to these places counts as that much. Finds strays within a spacing of the
/// surface, once those far from it are gone. [worker]
/// @param points  how many the neighbours were made of  @param times  > 0  @throw Cancelled
std::vector<std::uint32_t> withoutOffSurface(const PointNeighbours& neighbours, std::size_t points,
                                             double times, const Task& task);

}  // namespace relievo
