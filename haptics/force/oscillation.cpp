// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/force/oscillation.h"

#include <algorithm>
#include <cmath>

namespace relievo {

namespace {
/// Share of a step that a first-order low pass takes in 1 ms: w T / (1 + w T).
constexpr double share(double hertz) {
  constexpr double kTwoPi = 2 * 3.14159265358979323846;
  return kTwoPi * hertz * 1e-3 / (1 + kTwoPi * hertz * 1e-3);
}
constexpr double kSlow = share(20), kFast = share(300);

void add(OscillationState::Axis& axis, double force, double still) RELIEVO_REALTIME {
  axis.mean += kSlow * (force - axis.mean);
  axis.band += kFast * (force - axis.mean - axis.band);
  axis.low = std::min(axis.low, axis.band);
  axis.high = std::max(axis.high, axis.band);
  // With a dead zone: noise about zero is no crossing.
  if (axis.above ? axis.band < -still : axis.band > still) {
    axis.above = !axis.above;
    ++axis.crossings;
  }
}

bool swings(const OscillationState::Axis& axis, double allowed_n) RELIEVO_REALTIME {
  // Up and down within the block: a landing or a lift goes one way only.
  constexpr int kUpAndDown = 2;
  return axis.high - axis.low > allowed_n && axis.crossings >= kUpAndDown;
}
}  // namespace

OscillationState watchOscillation(const OscillationOptions& options, const OscillationInput& input,
                                  OscillationState state) RELIEVO_REALTIME {
  const DeviceN force = input.force;
  const DeviceMm hip = input.hip;
  if (!options.on) return {};
  if (!state.started) {
    const double factor = state.factor;
    const std::uint8_t softened = state.softened;
    state = {};
    state.factor = factor;
    state.softened = softened;
    state.axes[0].mean = force.x;
    state.axes[1].mean = force.y;
    state.axes[2].mean = force.z;
    state.block_start = hip;
    state.started = true;
  }
  const double still = 0.1 * options.peak_to_peak_n;
  add(state.axes[0], force.x, still);
  add(state.axes[1], force.y, still);
  add(state.axes[2], force.z, still);
  state.owed = state.owed || input.deep_in_debt;
  if (++state.ticks < kOscillationBlockTicks) return state;

  const double speed = norm(hip - state.block_start) / (1e-3 * kOscillationBlockTicks);
  const double allowed_n = options.peak_to_peak_n + options.per_speed_n_s_per_mm * speed;
  const bool swinging =
      state.owed || std::any_of(state.axes.begin(), state.axes.end(),
                                [allowed_n](const auto& axis) { return swings(axis, allowed_n); });
  state.swinging_blocks = swinging ? state.swinging_blocks + 1 : 0;
  constexpr int kBlocksThatCount = 2;
  if (state.swinging_blocks >= kBlocksThatCount && state.factor > options.least_factor) {
    state.factor = std::max(options.least_factor, 0.5 * state.factor);
    ++state.softened;
    state.swinging_blocks = 0;
  }
  for (OscillationState::Axis& axis : state.axes) {
    axis.low = axis.high = axis.band;
    axis.crossings = 0;
  }
  state.ticks = 0;
  state.owed = false;
  state.block_start = hip;
  return state;
}

}  // namespace relievo
