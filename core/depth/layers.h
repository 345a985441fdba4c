// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/base/vec3.h"

namespace relievo {

/// Are there places where the object lies behind itself, seen along -z? Looks at squares that hold
/// some eight points each: two groups of points, one far behind the other, over the same ground.
/// Walls and steps, whose groups lie side by side, do not count.
/// @param points  a sample of them is enough; mm, any origin
/// @return  share of the points that lie in such squares [worker]
double layeredShare(const std::vector<ViewMm>& points);
inline constexpr double kLayered = 0.1;  ///< From this share on the front is looked for in 3-D.

}  // namespace relievo
