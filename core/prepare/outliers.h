// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/base/task.h"
#include "core/neighbours/point_neighbours.h"
#include "core/prepare/recipe.h"

namespace relievo {

/// Numbers of the points that stay, rising: exactly those that pcl::StatisticalOutlierRemoval of
/// PCL 1.13 keeps, by its arithmetic. Missing neighbours, where there are fewer points than asked
/// for, count as distance 0. [worker]
/// @param points  how many the neighbours were made of  @throw Cancelled
std::vector<std::uint32_t> withoutOutliers(const PointNeighbours& neighbours, std::size_t points,
                                           const Outliers& step, const Task& task);

/// Numbers of the points that stay, rising: exactly those that pcl::RadiusOutlierRemoval keeps.
/// [worker]
/// @param radius  in the points' unit  @throw Cancelled
std::vector<std::uint32_t> withoutLonely(const PointNeighbours& neighbours, std::size_t points,
                                         double radius, int at_least, const Task& task);

/// Numbers of the points that stay, rising: those whose mean distance to their nearest places is at
/// most `factor` times the least of these places' own. [worker] @throw Cancelled
std::vector<std::uint32_t> withoutSparse(const PointNeighbours& neighbours, std::size_t points,
                                         const Sparse& step, const Task& task);

/// Median distance of a place to its nearest other, in the points' unit; 0 for fewer than two
/// places. [worker] @throw Cancelled
double spacingOf(const PointNeighbours& neighbours, const Task& task);

}  // namespace relievo
