// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "core/base/task.h"
#include "core/base/vec3.h"
#include "core/cloud/scan.h"

namespace relievo {

/// Points spread evenly over the surface: of the triangles by their area, of a cloud some of its
/// points. Relative to the scan's origin; the same for the same scan.
std::vector<FilePoint> surfaceSample(const Scan& scan, std::size_t most);

/// One of the file's axes, up or down.
struct FileDirection {
  int axis = 2;  ///< 0, 1, 2: x, y, z.
  int sign = 1;
  friend bool operator==(const FileDirection&, const FileDirection&) = default;
};

/// How an object stands.
struct Standing {
  FileDirection up;
  /// By how much this direction is likelier than any other; below kWeakStanding nobody should be
  /// surprised if another is right.
  double lead = 0;
  std::array<double, 3> size{};  ///< Along the file's axes.
  /// Thinner than this along one axis than along the others: a relief, which is looked at along it
  /// whichever way it stands.
  bool is_flat = false;
};
inline constexpr double kWeakStanding = 0.08;

/// From what an object would rest on (a base is a large level piece of surface at one end, with
/// nothing like it at the other), where the origin is, which axis is longest, and which axis files
/// of this format have upward. [worker]
Standing standingOf(const Scan& scan, const std::vector<FilePoint>& sample);

}  // namespace relievo
