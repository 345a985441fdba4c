// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "core/base/vec3.h"
#include "haptics/guide/guide.h"
#include "haptics/rt/realtime.h"

namespace relievo {

/// A marker that the hand is pulled back to while it feels the surface.
struct BeaconOptions {
  std::uint64_t id = 0;        ///< Another one begins a new pull; 0: none.
  DeviceMm place{};            ///< Mm of hand; its z does not count.
  std::uint64_t scene_id = 0;  ///< HapticSpace::scene_id of the surface that it lies on.
  friend bool operator==(const BeaconOptions&, const BeaconOptions&) = default;
};

/// The law of a beacon: a potential of the hand's distance r from it along x and y,
///   V = k (r^2 - r_0^2) / 2 up to the largest force, from there on linear;  F = -w grad V
/// with a weight w that rises from 0 to 1 so slowly that no more than kMostFedMw is fed in by it.
/// Added to the surface's force, which goes on being felt.
struct BeaconLaw {
  static constexpr double kNPerMm = 0.05, kMostN = 1;
  static constexpr double kThereMm = 3;  ///< r_0: nearer than this the hand is there.
  static constexpr double kRiseS = 0.5;  ///< The shortest rise of w.
  static constexpr double kFallS = 0.1;  ///< Of w, after the hand let go: takes energy away.
  static constexpr double kMostFedMw = 80;
  static constexpr double kMostS = 10;  ///< A pull takes no longer.
  /// The hand leads if it goes away from the beacon faster than this for kAgainstS (which drains
  /// twice as fast as it fills), or anywhere faster than GuideLaw::kFastMmPerS.
  static constexpr double kAwayMmPerS = 8, kAgainstS = 0.3;
};

struct BeaconState {
  std::uint64_t id = 0;  ///< Of the last pull; kept after its end, so that it begins once.
  GuideEnd end = GuideEnd::none;
  DeviceMm place{};
  double weight = 0;
  double since_s = 0;  ///< That it was felt.
  double away_s = 0, fast_s = 0;
  std::uint32_t buttons = 0;  ///< Of the last tick.
  bool pulls = false;         ///< False: it has ended; a weight that is left falls.
};

struct BeaconStep {
  BeaconState state{};
  DeviceN force{};       ///< On the hand, of full strength.
  double energy_mj = 0;  ///< Stands in it.
  double given_mj = 0;   ///< Of that: put in by the weight in this tick, and owed by nobody.
};

/// One tick of the nominal 1 kHz. In Move mode, and while the force rises, a pull waits.
BeaconStep pulledBack(const BeaconOptions& options, const GuideInput& input,
                      BeaconState state) RELIEVO_REALTIME;

}  // namespace relievo
