// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/guide/beacon_pull.h"

#include <algorithm>
#include <cmath>

namespace relievo {
namespace {

using Law = BeaconLaw;

/// Force and energy of the whole potential at a place.
struct Pull {
  DeviceN force{};
  double energy_mj = 0;
  DeviceMm direction{};  ///< To the beacon, unit length along x and y; zero: the hand is there.
  bool is_there = false;
};

// At r_0 it ends: with a force that went to zero there, the dry friction of a device's joints,
// 0.1 N, would hold the hand before it.
Pull pullAt(DeviceMm place, DeviceMm hand) RELIEVO_REALTIME {
  const DeviceMm way{place.x - hand.x, place.y - hand.y, 0};
  const double away_mm = norm(way);
  if (!(away_mm > Law::kThereMm)) return {.is_there = true};
  const DeviceMm u = (1 / away_mm) * way;
  constexpr double kBendMm = Law::kMostN / Law::kNPerMm;  // From here on the force is constant.
  const double force_n = std::min(Law::kNPerMm * away_mm, Law::kMostN);
  constexpr double kThereMj = 0.5 * Law::kNPerMm * Law::kThereMm * Law::kThereMm;
  const double energy_mj =
      (away_mm < kBendMm ? 0.5 * force_n * away_mm : Law::kMostN * (away_mm - 0.5 * kBendMm)) -
      kThereMj;
  return {{force_n * u.x, force_n * u.y, 0}, energy_mj, u, false};
}

GuideEnd endOf(const BeaconOptions& options, const GuideInput& input,
               const BeaconState& state) RELIEVO_REALTIME {
  if (!input.forces_on) return GuideEnd::no_forces;
  if (options.id != state.id) return GuideEnd::asked;
  if (options.scene_id != input.scene_id) return GuideEnd::surface;
  if (input.in_detent) return GuideEnd::none;  // Its buttons are Move mode's.
  if ((input.buttons & ~state.buttons) != 0) return GuideEnd::button;
  return GuideEnd::none;
}

/// What the hand itself ends, while it is pulled.
GuideEnd handsEnd(const Pull& pull, const GuideInput& input, BeaconState& state) RELIEVO_REALTIME {
  constexpr double kRounding = 1e-9;
  if (pull.is_there) return GuideEnd::arrived;
  const double away_mm_per_s =
      -(input.velocity.x * pull.direction.x + input.velocity.y * pull.direction.y);
  const bool goes_away = state.weight > 0 && away_mm_per_s > Law::kAwayMmPerS;
  state.away_s =
      goes_away ? state.away_s + input.dt_s : std::max(0.0, state.away_s - 2 * input.dt_s);
  const bool fast = norm(input.velocity) > GuideLaw::kFastMmPerS;
  state.fast_s = fast ? state.fast_s + input.dt_s : 0;
  const bool leads = state.away_s >= Law::kAgainstS - kRounding ||
                     state.fast_s >= GuideLaw::kFastS - kRounding ||
                     state.since_s >= Law::kMostS - kRounding;
  return leads ? GuideEnd::you_lead : GuideEnd::none;
}

double nextWeight(const BeaconState& state, bool held_back, double energy_mj,
                  double dt_s) RELIEVO_REALTIME {
  if (!state.pulls) return std::max(0.0, state.weight - dt_s / Law::kFallS);
  if (held_back) return state.weight;
  const double per_s = std::min(1 / Law::kRiseS, Law::kMostFedMw / std::max(energy_mj, 1e-6));
  return std::min(1.0, state.weight + per_s * dt_s);
}

}  // namespace

BeaconStep pulledBack(const BeaconOptions& options, const GuideInput& input,
                      BeaconState state) RELIEVO_REALTIME {
  if (options.id != state.id && options.id != 0 && options.scene_id == input.scene_id) {
    // A pull that is still felt jumps to nothing here and rises anew; the slew limit smooths it.
    state = {.id = options.id, .place = options.place, .buttons = input.buttons, .pulls = true};
  } else if (state.pulls) {
    const GuideEnd end = endOf(options, input, state);
    if (end != GuideEnd::none) {
      state.pulls = false;
      state.end = end;
    }
  }
  state.buttons = input.buttons;
  if (!input.forces_on) state.weight = 0;
  BeaconStep step;
  const Pull pull = pullAt(state.place, input.hand);
  const bool waits = input.in_detent || !(input.rise > 0);
  if (state.pulls && !waits) {
    state.since_s += input.dt_s;
    const GuideEnd end = handsEnd(pull, input, state);
    if (end != GuideEnd::none) {
      state.pulls = false;
      state.end = end;
    }
  }
  if (state.pulls || state.weight > 0) {
    const double before = state.weight;
    state.weight = nextWeight(state, waits, pull.energy_mj, input.dt_s);
    step.force = {state.weight * pull.force.x, state.weight * pull.force.y, 0};
    step.energy_mj = state.weight * pull.energy_mj;
    step.given_mj = (state.weight - before) * pull.energy_mj;
  }
  step.state = state;
  return step;
}

}  // namespace relievo
