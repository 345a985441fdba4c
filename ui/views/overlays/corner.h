// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace relievo {

// What lies in a corner of a view: a legend, a bar of colours, the ball of light. Pixels.

inline constexpr int kCornerMargin = 14;  ///< From the view's corner.
inline constexpr int kCornerPadding = 8;  ///< Between its edge and its words.

}  // namespace relievo
