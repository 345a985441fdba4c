// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <vector>

#include "core/base/task.h"
#include "core/base/vec3.h"

namespace relievo {

/// Where a hand was on an object at a time.
struct WayPoint {
  double t_s = 0;
  ViewMm place;
};

/// The way of somebody's hand, for others to be led along: of a recording (CSV or HDF5) the
/// proxy's, which stays on the surface; of a stroke (readStroke) its points, in view mm.
/// @throw FileError  as readLog and readStroke  @throw Cancelled
std::vector<WayPoint> readWay(const std::filesystem::path& file, const Task& task = {});

}  // namespace relievo
