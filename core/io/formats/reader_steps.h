// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>

namespace relievo {

// What readers of points have in common.

/// Points, rows or lines between two reports of progress, at which it can be cancelled.
inline constexpr std::uint64_t kReportEvery = 1 << 16;
/// A longer line is none of a file of points; bytes.
inline constexpr std::size_t kMaxPointLine = 65536;
/// A coordinate that the file has not.
inline constexpr double kNoCoordinate = std::numeric_limits<double>::quiet_NaN();

}  // namespace relievo
