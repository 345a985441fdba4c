// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/region/region.h"

namespace relievo {

// Continuous navigation: what the wheel and a SpaceMouse do with the window. Pure functions.

/// Side of the smallest window that one zooms in to, in cells of the finest level.
inline constexpr double kLeastWindowCells = 8;

/// About which place of the relief, view mm, and how much.
struct Zoom {
  double nearer = 1;  ///< The window's side is divided by it; > 0.
  double x_mm = 0, y_mm = 0;
};
/// The place stays where it is in the window, as far as the map goes; the level is the one for its
/// new side. The whole object where the window would be larger, and the smallest window, or `from`
/// if that is smaller, at the other end.
Region zoomed(const DetailLadder& ladder, const Region& from, const Zoom& zoom);

/// What carries the relief under the window.
struct Carry {
  double right = 0, up = 0;  ///< In parts of the window's side.
  double nearer = 1;         ///< As in Zoom, about the window's centre.
};
/// Kept on the map. With `nearer` at 1 the level stays.
Region carried(const DetailLadder& ladder, const Region& from, const Carry& by);

}  // namespace relievo
