// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "core/base/vec3.h"
#include "haptics/rt/realtime.h"

namespace relievo {

/// What the hand feels in Move mode in place of the surface: a soft detent with four ways, right,
/// left, up and down of where the hand was. On a way a weak spring that gives way at 20 mm with one
/// click; beside it a guide back to it. Where the window is at the object's edge there is a wall.
/// The force is the slope of a potential: nobody gains energy by going round. [haptic loop]
struct MoveDetent {
  bool on = false;
  DeviceMm centre;           ///< Where Move mode began.
  std::uint8_t blocked = 0;  ///< Ways with a wall: 1 left, 2 right, 4 down, 8 up.

  static constexpr double kWayNPerMm = 0.05;    ///< Spring along a way ...
  static constexpr double kClickMm = 18;        ///< ... up to here, 0.9 N ...
  static constexpr double kClickedMm = 22;      ///< ... from here on it has clicked ...
  static constexpr double kClickedN = 0.3;      ///< ... and pulls only so much.
  static constexpr double kGuideNPerMm = 0.1;   ///< Across a way ...
  static constexpr double kGuideMostN = 0.8;    ///< ... at most.
  static constexpr double kWallMm = 8;          ///< A wall begins here ...
  static constexpr double kWallNPerMm = 0.2;    ///< ... adds more than the click takes away ...
  static constexpr double kWallMostN = 2.8;     ///< ... and at most so much.
  static constexpr double kDepthNPerMm = 0.03;  ///< In and out, the hand is only held up.
  static constexpr double kDepthMostN = 0.5;
  friend bool operator==(const MoveDetent&, const MoveDetent&) = default;
};

/// On the hand at this place, before strength and limits. Zero if the detent is off.
DeviceN detentForce(const MoveDetent& detent, DeviceMm hand) RELIEVO_REALTIME;

}  // namespace relievo
