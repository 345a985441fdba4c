// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include "core/base/task.h"
#include "core/neighbours/point_neighbours.h"
#include "core/prepare/recipe.h"

namespace relievo {

/// Numbers of the points that stay, rising: of every cube of side `spacing`, counted from the
/// frame's origin, the point nearest its middle; of two as near the first. [worker]
/// @param centre  added to every point; with `spacing` in the points' unit
/// @throw ArgumentError  more than 2^21 cubes along a side  @throw Cancelled
std::vector<std::uint32_t> thinned(std::span<const Point3f> points, const FilePoint& centre,
                                   double spacing, const Task& task);

/// Numbers of the points that stay, rising: the first of those with equal coordinates. [worker]
/// @throw Cancelled
std::vector<std::uint32_t> withoutDuplicates(std::span<const Point3f> points, const Task& task);

}  // namespace relievo
