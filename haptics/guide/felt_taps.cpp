// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/guide/felt_taps.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace relievo {
namespace {

using Law = TapLaw;

/// The next moment of a pattern that is felt. @return its force
double nextForce(const GuideInput& input, TapState& state) RELIEVO_REALTIME {
  constexpr double kRounding = 1e-9;
  if (state.since_s >= Law::kApartS - kRounding) {
    state.since_s = 0;
    state.from_mm = input.hand.z;
  }
  const double t_s = state.since_s;
  state.since_s += input.dt_s;
  if (t_s < Law::kLastsS - kRounding) {
    return Law::kMostN * std::sin(std::numbers::pi * t_s / Law::kLastsS);
  }
  // The pause after the last one is none of it.
  if (state.left == 1 || state.since_s >= Law::kApartS - kRounding) --state.left;
  return 0;
}

}  // namespace

TapStep tapped(const TapOptions& options, const GuideInput& input,
               TapState state) RELIEVO_REALTIME {
  if (options.id != state.id && options.id != 0) {
    const double before_n = state.force_n, from_mm = state.from_mm;
    state = {.id = options.id,
             .left = static_cast<std::uint8_t>(options.pattern),
             .from_mm = before_n > 0 ? from_mm : input.hand.z,
             .force_n = before_n};  // A tap that is cut off gives its energy back.
  }
  const bool waits = input.in_detent || !(input.rise > 0);
  if (!input.forces_on) state.left = 0;
  double force_n = 0;
  if (state.left > 0 && waits) {
    state.waited_s += input.dt_s;
    if (state.since_s > 0 || state.waited_s > Law::kWaitsS) state.left = 0;
  } else if (state.left > 0 && !(state.since_s == 0 && state.force_n > 0)) {
    if (state.since_s == 0) state.from_mm = input.hand.z;
    force_n = nextForce(input, state);
  }
  TapStep step;
  const double way_mm = input.hand.z - state.from_mm;
  step.force = {0, 0, force_n};
  step.energy_mj = -force_n * way_mm;
  step.given_mj = -(force_n - state.force_n) * way_mm;
  state.force_n = force_n;
  step.state = state;
  return step;
}

}  // namespace relievo
