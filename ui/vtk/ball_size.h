// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace relievo {

/// Radius of the balls of hand and proxy on screen and in videos, of the window's side.
inline constexpr double kBallOfSide = 0.017;

}  // namespace relievo
