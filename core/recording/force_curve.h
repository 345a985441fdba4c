// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <vector>

#include "core/base/task.h"
#include "core/recording/force_point.h"
#include "core/recording/touch_row.h"

namespace relievo {

/// What the plots show of a row. [any thread]
inline ForcePoint forcePoint(const TouchRow& row) {
  return {row.t_s, row.hip.z, row.proxy.z, norm(row.force)};
}

/// The points of a recording, CSV or HDF5, of which plots need the fewest columns. [worker]
/// @throw FileError  as readLog  @throw Cancelled
std::vector<ForcePoint> readForceCurve(const std::filesystem::path& file, const Task& task = {});

}  // namespace relievo
