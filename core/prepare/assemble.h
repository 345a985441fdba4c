// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/base/task.h"
#include "core/cloud/scan.h"
#include "core/prepare/point_bits.h"
#include "core/prepare/recipe.h"

namespace relievo {

/// One scan of what is left of several: colours, intensities, classes, parts and triangles follow
/// their points; triangles that lost a corner go. A single scan that was not moved keeps the bytes
/// of its points; else every pose is applied in double. [worker]
/// @param poses  one for each scan  @param kept  of the points of all scans, one after the other
/// @pre at least one scan, all in one unit
/// @throw ArgumentError  no point is left  @throw Cancelled
Scan assembled(const std::vector<const Scan*>& scans, const std::vector<Pose>& poses,
               const PointBits& kept, const Task& task);

}  // namespace relievo
