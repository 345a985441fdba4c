// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "core/base/vec3.h"
#include "haptics/guide/guide_path.h"
#include "haptics/rt/realtime.h"

namespace relievo {

/// Which path the hand is to be led along.
struct GuideOptions {
  std::uint64_t path = 0;  ///< GuidePath::id; another one begins a new run; 0: none.
  friend bool operator==(const GuideOptions&, const GuideOptions&) = default;
};

enum class GuidePhase : std::uint8_t {
  off,
  approaching,  ///< Straight from where the hand was to the nearest place of the path.
  leading,
  pausing,  ///< At a corner.
};

/// Why a run came to its end.
enum class GuideEnd : std::uint8_t {
  none,       ///< There was none, or it goes on.
  arrived,    ///< At the end of an open path, or after all rounds.
  you_lead,   ///< The hand pushed against it, or was faster than it.
  button,     ///< Any button went down.
  asked,      ///< The options name no path any more, or Move mode began.
  no_forces,  ///< They are off, or the device failed.
  surface,    ///< Another surface lies under the hand.
};

/// The law of a hand that is led: stiff across the path, weak along it, and a target that waits for
/// the hand. So nobody is pulled along, and a round way stays round (a spring to a moving target
/// cuts inside of it). With p the hand, c the place of the path near it, u the path's direction
/// there, s_c and s the ways of c and of the target, v the hand's velocity:
///   F = k_across (c - p) + clamp(k_along (s - s_c), +-along_most) u + b (s' u - v),  |F| <= 2 N
///   s' = v_0 clamp((16 - lag) / 13, 0, 1)
/// Source: the guided mode of Lieb et al. 2020 (doi 10.1145/3373625.3417007); the numbers are ours.
struct GuideLaw {
  static constexpr double kAcrossNPerMm = 0.4;
  static constexpr double kAlongNPerMm = 0.1, kAlongMostN = 1.8;
  static constexpr double kDampingNSPerMm = 0.002;
  static constexpr double kMostN = 2;          ///< Of all of it.
  static constexpr double kMostFedMw = 80;     ///< What the target's way may feed in: 2 N, 40 mm/s.
  static constexpr double kWaitsMm = 16;       ///< So far ahead of the hand the target stands ...
  static constexpr double kFullMm = 3;         ///< ... and up to here it has its full speed.
  static constexpr double kMostMmPerS2 = 200;  ///< Of the target.
  static constexpr double kSearchMm = 6;       ///< c is looked for so far along the path.
  static constexpr double kNearMm = 2;         ///< The hand is there.
  static constexpr double kAgainstN = 1.5, kAgainstS = 0.3;  ///< Then the hand leads; drains twice
                                                             ///< as fast as it fills.
  static constexpr double kFastMmPerS = 250, kFastS = 0.02;  ///< Likewise.
  static constexpr double kApproachS = 10;                   ///< It takes no longer.
  static constexpr double kArrivalS = 2;                     ///< Waits so long for the hand.
};

struct GuideState {
  std::uint64_t path = 0;  ///< Of the last run; kept after its end, so that it begins once.
  GuidePhase phase = GuidePhase::off;
  GuideEnd end = GuideEnd::none;
  DeviceMm from, to;     ///< The way of the approach.
  double path_mm = 0;    ///< Where on the path it began.
  double target_mm = 0;  ///< Way of the target: of the approach, else from the path's start ...
  double hand_mm = 0;    ///< ... and of the place near the hand. Goes on over all rounds.
  double speed_mm_per_s = 0;  ///< Of the target.
  double pause_s = 0;         ///< Still to wait.
  double since_s = 0;         ///< Of the approach, or of the arrival.
  double against_s = 0, fast_s = 0;
  std::uint32_t buttons = 0;  ///< Of the last tick.
};

struct GuideInput {
  DeviceMm hand;
  DeviceMm velocity;          ///< Of the hand, mm/s, filtered.
  std::uint32_t buttons = 0;  ///< That are down.
  std::uint64_t scene_id = 0;
  bool forces_on = false;  ///< Asked for, and nothing is at fault.
  bool in_detent = false;  ///< Move mode.
  double rise = 0;         ///< How much of the force is felt: risen, and not softened; 0 .. 1.
  double sent_most_n = 0;  ///< No more can be sent in this tick.
  double dt_s = 0.001;     ///< Nominal.
};

struct GuideStep {
  GuideState state;
  DeviceN force;       ///< On the hand, of full strength; zero while `on` is false.
  DeviceMm direction;  ///< The path's, unit length; zero while `on` is false.
  bool on = false;     ///< It is felt in place of the surface.
};

/// One tick of the nominal 1 kHz.
/// @param path  of that id; null: it is not there, and nothing is led
GuideStep guided(const GuideOptions& options, const GuidePath* path, const GuideInput& input,
                 GuideState state) RELIEVO_REALTIME;

}  // namespace relievo
