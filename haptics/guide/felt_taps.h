// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "core/base/vec3.h"
#include "haptics/guide/guide.h"
#include "haptics/rt/realtime.h"

namespace relievo {

/// What is said to a hand whose person neither sees nor hears, by its number of taps.
enum class FeltPattern : std::uint8_t { none = 0, yes = 1, not_measured = 2, edge = 3 };

struct TapOptions {
  std::uint64_t id = 0;  ///< Another one begins a new pattern; 0: none.
  FeltPattern pattern = FeltPattern::none;
  friend bool operator==(const TapOptions&, const TapOptions&) = default;
};

/// The law of a pattern: so many times, kApartS from one beginning to the next,
///   F_z = kMostN sin(pi t / kLastsS),  0 <= t < kLastsS
/// towards the person, added to what is felt of the surface. Its energy is counted as put in by it
/// and owed by nobody: less than 1 mJ a tap, of a hand of 100 g.
struct TapLaw {
  static constexpr double kMostN = 0.4, kLastsS = 0.03, kApartS = 0.15;
  static constexpr double kWaitsS = 1;  ///< What cannot be felt so long is not felt any more.
};

struct TapState {
  std::uint64_t id = 0;   ///< Of the last pattern; kept after its end, so that it begins once.
  std::uint8_t left = 0;  ///< Taps, with the one that is felt now.
  double since_s = 0;     ///< The beginning of that one.
  double waited_s = 0;
  double from_mm = 0;  ///< Where the hand's z was at its beginning ...
  double force_n = 0;  ///< ... and its force in the last tick.
};

struct TapStep {
  TapState state{};
  DeviceN force{};       ///< On the hand, of full strength.
  double energy_mj = 0;  ///< Stands in it.
  double given_mj = 0;   ///< Of that: put in by the law in this tick, and owed by nobody.
};

/// One tick of the nominal 1 kHz. Where no force is felt, in Move mode and while the hand is led a
/// pattern that has not begun waits; one that has begun ends there.
TapStep tapped(const TapOptions& options, const GuideInput& input, TapState state) RELIEVO_REALTIME;

}  // namespace relievo
