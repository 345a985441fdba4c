// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <vector>

#include "core/base/task.h"
#include "core/recording/touch_row.h"

namespace relievo {

/// One point of the two plots of a touch (paper, force figure).
struct ForcePoint {
  double t_s = 0;
  double hip_z_mm = 0, proxy_z_mm = 0;  ///< View mm.
  double force_n = 0;                   ///< Norm of the force on the hand.
};

/// What the plots show of a row. [any thread]
inline ForcePoint forcePoint(const TouchRow& row) {
  return {row.t_s, row.hip.z, row.proxy.z, norm(row.force)};
}

/// The points of a recording, CSV or HDF5, of which plots need the fewest columns. [worker]
/// @throw FileError  as readLog  @throw Cancelled
std::vector<ForcePoint> readForceCurve(const std::filesystem::path& file, const Task& task = {});

}  // namespace relievo
