// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "haptics/rt/realtime.h"
#include "haptics/space/haptic_space.h"

namespace relievo {

/// Sides of the window over which a touching hand pushes; bits of HapticSample::frame.
inline constexpr std::uint8_t kFrameLeft = 1, kFrameRight = 2, kFrameLow = 4, kFrameHigh = 8;

/// The window's soft frame. Beyond the outermost samples there is nothing to feel: the proxy
/// follows the nearest place over the window, so that it does not run off and jump back, and the
/// hand is asked back gently, never by more than a part of what it presses with: no hand is thrown
/// that only touches down beyond the edge. [haptic loop]
class SceneFrame {
 public:
  static constexpr double kSoftness = 0.2;          ///< Part of the spring's stiffness.
  static constexpr double kMostPart = 0.5;          ///< Of the depth of the hand below the surface.
  static constexpr double kMostMm = 2;              ///< Of spring, mm of hand; 1 N at 0.5 N/mm.
  static constexpr double kPushMm = 3;              ///< Beyond the edge, mm of hand ...
  static constexpr std::uint32_t kPushTicks = 300;  ///< ... for so long asks for the next window.

  /// The hand's place over the window nearest to `hip`.
  static GridPoint confined(GridPoint hip) RELIEVO_REALTIME;
  /// Where the spring ends instead of at the hand, for a proxy that followed confined(hip).
  static GridPoint felt(const HapticSpace& space, GridPoint hip, GridPoint proxy) RELIEVO_REALTIME;
  /// One tick. @return sides over which the hand has pushed for long enough: pan that way
  std::uint8_t push(const HapticSpace& space, GridPoint hip, bool contact) RELIEVO_REALTIME;

 private:
  std::uint32_t pushing_ticks_ = 0;
};

}  // namespace relievo
