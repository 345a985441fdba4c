// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "core/base/vec3.h"
#include "haptics/rt/realtime.h"
#include "haptics/space/haptic_space.h"
#include "haptics/space/workspace.h"

namespace relievo {

/// Sides of the window over which a touching hand pushes; bits of HapticSample::frame.
inline constexpr std::uint8_t kFrameLeft = 1, kFrameRight = 2, kFrameLow = 4, kFrameHigh = 8;

/// Where a hand is felt to be, and how fast that place goes with it along x and y: 1 over the
/// window, 0 beyond it.
struct FramedHand {
  GridPoint place;
  double along_x = 1, along_y = 1;
  bool whole() const RELIEVO_REALTIME { return along_x == 1 && along_y == 1; }
};

/// A push of the hand's place alone, and the energy that stands in it.
struct Cushion {
  DeviceN force;
  double energy_mj = 0;
};

/// The window's soft frame and the workspace's edge. Beyond the outermost samples there is nothing
/// to feel: the proxy follows a place over the window that comes to a stop at the edge, and a
/// cushion asks the hand back. Both are one potential with the spring: the energy of a hand is that
/// of the spring from its framed place, plus the cushion's, which knows the hand's place alone.
/// Whoever goes round, over the edge and back, gains nothing. [haptic loop]
class SceneFrame {
 public:
  static constexpr double kRoundingMm = 1;          ///< The place comes to its stop over so much.
  static constexpr double kCushionNPerMm = 0.15;    ///< From the edge on ...
  static constexpr double kCushionMostN = 1;        ///< ... and at most so much.
  static constexpr double kPushMm = 3;              ///< Beyond the edge, mm of hand ...
  static constexpr std::uint32_t kPushTicks = 300;  ///< ... for so long asks for the next window.

  static FramedHand framed(const HapticSpace& space, GridPoint hand) RELIEVO_REALTIME;
  /// @param window  beside a window the cushion begins at its outermost samples, else at the
  ///                workspace's sides; in and out always at the workspace's
  static Cushion cushion(const HapticSpace& space, const Workspace& workspace, DeviceMm hand,
                         bool window) RELIEVO_REALTIME;
  /// One tick. @return sides over which the hand has pushed for long enough: pan that way
  std::uint8_t push(const HapticSpace& space, GridPoint hip, bool contact) RELIEVO_REALTIME;

 private:
  friend struct NamedFields;  // Recordings hold every member by its name.
  std::uint32_t pushing_ticks_ = 0;
};

}  // namespace relievo
