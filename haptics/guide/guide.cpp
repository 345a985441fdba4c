// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/guide/guide.h"

#include <algorithm>
#include <cmath>

namespace relievo {
namespace {

using Law = GuideLaw;

/// A place of the path, and its direction from there on.
struct OnPath {
  DeviceMm place, direction;
  double mm = 0;
};

double square(double value) RELIEVO_REALTIME {
  return value * value;
}

/// Way within a round.
double within(const GuidePath& path, double mm) RELIEVO_REALTIME {
  const double length = path.lengthMm();
  if (path.closed) mm -= length * std::floor(mm / length);
  return std::clamp(mm, 0.0, length);
}

DeviceMm directionOf(const GuidePath& path, std::uint32_t stretch) RELIEVO_REALTIME {
  const DeviceMm way = path.end(stretch) - path.start(stretch);
  const double length = norm(way);
  return length > 0 ? (1 / length) * way : DeviceMm{};
}

OnPath placeOn(const GuidePath& path, double mm) RELIEVO_REALTIME {
  const double local = within(path, mm);
  const std::uint32_t stretch = path.stretchAt(local);
  const DeviceMm u = directionOf(path, stretch);
  return {path.start(stretch) + (local - path.at_mm[stretch]) * u, u, mm};
}

/// The place between two ways along the path that is near the hand. Where the path passes the same
/// places twice, as at a turn, the one near the target: its way counts a little.
OnPath nearHand(const GuidePath& path, DeviceMm hand, double from_mm, double to_mm,
                double target_mm) RELIEVO_REALTIME {
  constexpr double kOfTarget = 0.0025, kSameCost = 1e-6;
  const double length = path.lengthMm();
  double round_mm = path.closed ? length * std::floor(from_mm / length) : 0;
  std::uint32_t stretch = path.stretchAt(within(path, from_mm));
  OnPath best = placeOn(path, from_mm);
  double least = 1e300;
  for (std::uint32_t i = 0; i <= path.stretches(); ++i) {
    const double start_mm = round_mm + path.at_mm[stretch];
    if (start_mm > to_mm) break;
    const double low = std::max(0.0, from_mm - start_mm);
    const double high = std::min(path.at_mm[stretch + 1] - path.at_mm[stretch], to_mm - start_mm);
    if (low <= high) {
      const DeviceMm u = directionOf(path, stretch);
      const DeviceMm off = hand - path.start(stretch);
      const double along = std::clamp(
          (dot(off, u) + kOfTarget * (target_mm - start_mm)) / (1 + kOfTarget), low, high);
      const DeviceMm left = off - along * u;
      const double cost = dot(left, left) + kOfTarget * square(start_mm + along - target_mm);
      if (cost <= least + kSameCost) {  // At a corner the stretch that goes on.
        least = std::min(least, cost);
        best = {path.start(stretch) + along * u, u, start_mm + along};
      }
    }
    if (++stretch == path.stretches()) {
      if (!path.closed) break;
      stretch = 0;
      round_mm += length;
    }
  }
  return best;
}

/// Where a hand that comes from elsewhere joins: an open path at its start.
double joinedAt(const GuidePath& path, DeviceMm hand) RELIEVO_REALTIME {
  if (!path.closed) return 0;
  double least = 1e300, mm = 0;
  for (std::uint32_t i = 0; i < path.stretches(); ++i) {
    const double way = path.at_mm[i + 1] - path.at_mm[i];
    const DeviceMm u = directionOf(path, i);
    const DeviceMm off = hand - path.start(i);
    const double along = std::clamp(dot(off, u), 0.0, way);
    const DeviceMm left = off - along * u;
    if (dot(left, left) >= least) continue;
    least = dot(left, left);
    mm = path.at_mm[i] + along;
  }
  return mm;
}

GuideState begun(std::uint64_t id, const GuidePath& path,
                 const GuideInput& input) RELIEVO_REALTIME {
  GuideState state;
  state.path = id;
  state.phase = GuidePhase::approaching;
  state.from = input.hand;
  state.path_mm = joinedAt(path, input.hand);
  state.to = placeOn(path, state.path_mm).place;
  state.buttons = input.buttons;
  return state;
}

GuideState ended(GuideState state, GuideEnd end) RELIEVO_REALTIME {
  state.phase = GuidePhase::off;
  state.end = end;
  state.speed_mm_per_s = 0;
  return state;
}

/// What ends a run whatever the force is.
GuideEnd endOf(const GuidePath* path, const GuideInput& input,
               const GuideState& state) RELIEVO_REALTIME {
  if (!input.forces_on) return GuideEnd::no_forces;
  if (input.in_detent || path == nullptr) return GuideEnd::asked;
  if (path->scene_id != input.scene_id) return GuideEnd::surface;
  if ((input.buttons & ~state.buttons) != 0) return GuideEnd::button;
  return GuideEnd::none;
}

/// Moves the target on, as fast as the hand follows. @param left_mm  to its next stop
void advance(double wanted_mm_per_s, double left_mm, double lag_mm, const GuideInput& input,
             GuideState& state) RELIEVO_REALTIME {
  const double leash =
      std::clamp((Law::kWaitsMm - lag_mm) / (Law::kWaitsMm - Law::kFullMm), 0.0, 1.0);
  double speed = std::min(input.rise * leash * wanted_mm_per_s,
                          state.speed_mm_per_s + Law::kMostMmPerS2 * input.dt_s);
  speed = std::min(speed, std::sqrt(2 * Law::kMostMmPerS2 * std::max(0.0, left_mm)));
  speed = std::min(speed, Law::kMostFedMw / std::max(input.sent_most_n, 1e-3));
  state.speed_mm_per_s = speed;
  state.target_mm += std::min(speed * input.dt_s, left_mm);
}

/// The law's force at a place, and whether the hand leads now.
DeviceN pull(const OnPath& near, const GuideInput& input, GuideState& state) RELIEVO_REALTIME {
  const DeviceMm across = near.place - input.hand;
  const double along = std::clamp(Law::kAlongNPerMm * (state.target_mm - near.mm),
                                  -Law::kAlongMostN, Law::kAlongMostN);
  const DeviceMm slip = state.speed_mm_per_s * near.direction - input.velocity;
  const DeviceMm sum =
      Law::kAcrossNPerMm * across + along * near.direction + Law::kDampingNSPerMm * slip;
  const double size = norm(sum);
  const double part = size > Law::kMostN ? Law::kMostN / size : 1;
  // What the hand does not feel yet it cannot push against.
  const double felt_n = input.rise * part * size;
  state.against_s = felt_n > Law::kAgainstN ? state.against_s + input.dt_s
                                            : std::max(0.0, state.against_s - 2 * input.dt_s);
  const bool fast = norm(input.velocity) > Law::kFastMmPerS;
  state.fast_s = fast ? state.fast_s + input.dt_s : 0;
  return {part * sum.x, part * sum.y, part * sum.z};
}

bool handLeads(const GuideState& state) RELIEVO_REALTIME {
  constexpr double kRounding = 1e-9;
  return state.against_s >= Law::kAgainstS - kRounding || state.fast_s >= Law::kFastS - kRounding;
}

/// Straight to where the path is joined, and on from there.
OnPath approach(const GuidePath& path, const GuideInput& input,
                GuideState& state) RELIEVO_REALTIME {
  // Until the force is felt the hand goes where it wants.
  if (!(input.rise > 0)) state = begun(state.path, path, input);
  const DeviceMm way = state.to - state.from;
  const double length = norm(way);
  const DeviceMm u = length > 0 ? (1 / length) * way : directionOf(path, 0);
  state.hand_mm = std::clamp(dot(input.hand - state.from, u), 0.0, length);
  const double lag = state.target_mm - state.hand_mm;
  advance(kGuideMmPerS, length - state.target_mm, lag, input, state);
  state.since_s += input.rise > 0 ? input.dt_s : 0;
  const bool is_there =
      input.rise > 0 && state.target_mm >= length && norm(input.hand - state.to) < Law::kNearMm;
  if (is_there) {
    state.phase = GuidePhase::pausing;
    state.pause_s = kCornerPauseS;
    state.target_mm = state.hand_mm = state.path_mm;
    state.speed_mm_per_s = state.since_s = 0;
    return placeOn(path, state.path_mm);
  }
  if (state.since_s > Law::kApproachS) state = ended(state, GuideEnd::you_lead);
  return {state.from + state.hand_mm * u, u, state.hand_mm};
}

/// Way to the next place at which the target stops.
double toStop(const GuidePath& path, const GuideState& state) RELIEVO_REALTIME {
  const double end_mm =
      path.closed ? state.path_mm + path.rounds * path.lengthMm() : path.lengthMm();
  const double local = within(path, state.target_mm);
  const std::uint32_t stretch = path.stretchAt(local);
  const double gone = local - path.at_mm[stretch];
  return std::min(path.to_stop_mm[stretch] - gone, end_mm - state.target_mm);
}

/// A stop is where the target is: waits, or has arrived.
void halt(const GuidePath& path, GuideState& state) RELIEVO_REALTIME {
  const double end_mm =
      path.closed ? state.path_mm + path.rounds * path.lengthMm() : path.lengthMm();
  constexpr double kThereMm = 1e-6;
  state.speed_mm_per_s = 0;
  if (state.target_mm >= end_mm - kThereMm) return;
  const double local = within(path, state.target_mm + kThereMm);
  const double pause_s = path.points[path.stretchAt(local)].pause_s;
  state.pause_s = pause_s;
  state.phase = pause_s > 0 ? GuidePhase::pausing : GuidePhase::leading;
  state.target_mm += kThereMm;  // The next stop is another one.
}

OnPath lead(const GuidePath& path, const GuideInput& input, GuideState& state) RELIEVO_REALTIME {
  const OnPath near = nearHand(path, input.hand, state.hand_mm - Law::kSearchMm,
                               state.hand_mm + Law::kSearchMm, state.target_mm);
  state.hand_mm = near.mm;
  if (state.phase == GuidePhase::pausing) {
    state.pause_s -= input.dt_s;
    if (state.pause_s <= 0) state.phase = GuidePhase::leading;
    return near;
  }
  const double end_mm =
      path.closed ? state.path_mm + path.rounds * path.lengthMm() : path.lengthMm();
  const double lag = state.target_mm - near.mm;
  constexpr double kThereMm = 1e-6;
  if (state.target_mm >= end_mm - kThereMm) {
    state.since_s += input.dt_s;
    if (lag < Law::kNearMm || state.since_s > Law::kArrivalS) {
      state = ended(state, GuideEnd::arrived);
    }
    return near;
  }
  const std::uint32_t stretch = path.stretchAt(within(path, state.target_mm));
  const double left = toStop(path, state);
  const double before = state.target_mm;
  advance(path.points[stretch].speed_mm_per_s, left, lag, input, state);
  if (state.target_mm >= before + left - kThereMm) halt(path, state);
  return near;
}

}  // namespace

GuideStep guided(const GuideOptions& options, const GuidePath* path, const GuideInput& input,
                 GuideState state) RELIEVO_REALTIME {
  GuideStep step;
  const bool begins = options.path != state.path && options.path != 0 && path != nullptr &&
                      path->id == options.path;
  if (begins) {
    state = begun(options.path, *path, input);
  } else if (state.phase != GuidePhase::off && (options.path != state.path)) {
    state = ended(state, GuideEnd::asked);
  }
  if (state.phase != GuidePhase::off) {
    const GuideEnd end = endOf(path, input, state);
    if (end != GuideEnd::none) state = ended(state, end);
  }
  state.buttons = input.buttons;
  if (state.phase != GuidePhase::off) {
    const OnPath near = state.phase == GuidePhase::approaching ? approach(*path, input, state)
                                                               : lead(*path, input, state);
    if (state.phase != GuidePhase::off) {
      step.force = pull(near, input, state);
      step.direction = near.direction;
      if (handLeads(state)) {
        state = ended(state, GuideEnd::you_lead);
        step.force = {};
        step.direction = {};
      }
    }
  }
  step.on = state.phase != GuidePhase::off;
  step.state = state;
  return step;
}

}  // namespace relievo
