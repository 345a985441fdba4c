// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/force/force_model.h"

#include <algorithm>
#include <cmath>

namespace relievo {

double stiffnessForDetail(int detail, const DetailStiffness& of) RELIEVO_REALTIME {
  constexpr int kLast = static_cast<int>(std::tuple_size_v<DetailStiffness>);
  return of[static_cast<std::size_t>(std::clamp(detail, 1, kLast) - 1)];
}

DeviceN springForce(const ForceOptions& options, const ForceInput& input) RELIEVO_REALTIME {
  if (!input.contact) return {};
  const DeviceMm out = input.proxy - input.hip;
  const double k = options.stiffness_n_per_mm;
  return {k * out.x, k * out.y, k * out.z};
}

DeviceN dampingForce(const ForceOptions& options, const ForceInput& input) RELIEVO_REALTIME {
  const double speed = dot(input.velocity, input.normal);
  if (!input.contact || !(speed < 0) || dot(input.moved, input.normal) > 0) return {};
  const double size = -options.damping_n_s_per_mm * speed;
  return {size * input.normal.x, size * input.normal.y, size * input.normal.z};
}

ForceState engage(const ForceOptions& options, const ForceInput& input, DeviceN spring,
                  ForceState state) RELIEVO_REALTIME {
  if (!options.forces_on || input.fault) {
    state.phase = EngagePhase::off;
    state.rise = 0;
    state.quiet = 0;
    state.oscillation = {};
    return state;
  }
  switch (state.phase) {
    case EngagePhase::off:
      state.phase = EngagePhase::waiting;
      state.quiet = 0;
      [[fallthrough]];
    case EngagePhase::waiting:
      // Written so that a force that is not a number is not quiet.
      state.quiet = norm(spring) < options.quiet_n ? state.quiet + 1 : 0;
      state.rise = 0;
      if (state.quiet >= options.quiet_ticks) state.phase = EngagePhase::rising;
      break;
    case EngagePhase::rising:
      state.rise = std::min(1.0, state.rise + input.dt_s / options.rise_s);
      if (state.rise >= 1) state.phase = EngagePhase::on;
      break;
    case EngagePhase::on:
      state.rise = 1;
      break;
  }
  return state;
}

DeviceN slewed(DeviceN wanted, DeviceN last, double step_n) RELIEVO_REALTIME {
  const DeviceN change = wanted - last;
  const double size = norm(change);
  return size <= step_n ? wanted : last + (step_n / size) * change;
}

DeviceN capped(DeviceN force, double limit_n) RELIEVO_REALTIME {
  const double size = norm(force);
  return size <= limit_n ? force : (limit_n / size) * force;
}

double limitForAge(const ForceOptions& options, double age_s) RELIEVO_REALTIME {
  if (!(age_s > options.stale_after_s)) return options.limit_n;
  const double left = options.stale_zero_s - age_s;
  return options.limit_n * std::max(0.0, left / (options.stale_zero_s - options.stale_after_s));
}

DeviceN finiteOrZero(DeviceN force) RELIEVO_REALTIME {
  return isFinite(force) ? force : DeviceN{};
}

ForceState refade(ForceState state) RELIEVO_REALTIME {
  if (state.phase == EngagePhase::on) state.phase = EngagePhase::rising;
  state.rise = 0;
  state.passivity = rebased(state.passivity);
  state.oscillation.started = false;
  return state;
}

ForceState resumed(ForceState state) RELIEVO_REALTIME {
  state = refade(state);
  state.last = {};
  state.passivity.sent = {};
  return state;
}

bool zeroDemanded(const ForceOptions& options, const ForceInput& input,
                  const ForceState& state) RELIEVO_REALTIME {
  return !options.forces_on || input.fault || input.resumed || !(options.strength > 0) ||
         state.phase == EngagePhase::off || state.phase == EngagePhase::waiting ||
         !(input.age_s < options.stale_zero_s);
}

namespace {
/// Watches the port and adds what is owed to the sum of the springs.
DeviceN passiveSum(const ForceOptions& options, const ForceInput& input, DeviceN sum,
                   ForceState& state, ForceResult& result) RELIEVO_REALTIME {
  const double gain = options.strength * state.rise;
  const double spring_mm = input.spring_mm < 0 ? norm(input.proxy - input.hip) : input.spring_mm;
  const double length_mm = input.contact ? spring_mm : 0;
  const double stored_mj =
      springEnergyMj(gain * options.stiffness_n_per_mm, length_mm, options.limit_n) +
      gain * input.fields_mj;
  state.passivity.stored_mj += gain * input.given_mj;
  state.passivity = observe(options.passivity, input.moved, stored_mj, state.passivity);
  const DeviceN damping = passivityForce(options.passivity, state.passivity, input.velocity,
                                         input.speed_window_s, input.dt_s);
  result.damped = damping;
  return sum + damping;
}
}  // namespace

namespace {
/// A knock on top of the other forces, where the options ask for any.
DeviceN knockOn(const ForceOptions& options, const ForceInput& input, DeviceN sum,
                ForceState& state) RELIEVO_REALTIME {
  const TransientOptions& o = options.transient;
  if (!(o.contact_n > 0) && !(o.crossing_n > 0)) {
    state.transient = {};
    return {};
  }
  const DeviceMm n = input.normal;
  const double pushed_n = sum.x * n.x + sum.y * n.y + sum.z * n.z;
  const ContactTransient now =
      knock(o, {n, input.velocity, input.moved, pushed_n, input.contact, input.measured},
            state.transient);
  state.transient = now.state;
  return now.force;
}
}  // namespace

namespace {
/// Spring and damper.
DeviceN pressedForce(const ForceOptions& options, const ForceInput& input) RELIEVO_REALTIME {
  const DeviceN spring = springForce(options, input);
  return options.damping_n_s_per_mm > 0 ? spring + dampingForce(options, input) : spring;
}
}  // namespace

ForceResult bareForce(const ForceOptions& options, const ForceInput& input,
                      ForceState state) RELIEVO_REALTIME {
  DeviceN sum = pressedForce(options, input) + input.fields;
  sum = finiteOrZero(sum + knockOn(options, input, sum, state));
  state.last = sum;
  return {sum, norm(sum), false, options.limit_n, {}, state};
}

DeviceN liftOf(const ForceOptions& options, double rise) RELIEVO_REALTIME {
  const double up_n = rise * options.lift_n;
  return options.lift_out ? DeviceN{0, 0, up_n} : DeviceN{0, up_n, 0};
}

ForceResult force(const ForceOptions& options, const ForceInput& input,
                  ForceState state) RELIEVO_REALTIME {
  const DeviceN pressed = pressedForce(options, input);
  DeviceN sum = pressed + input.fields;
  const DeviceN knocked = knockOn(options, input, sum, state);
  sum = sum + knocked;
  ForceResult result;
  state = engage(options, input, pressed, state);
  result.limit_n = input.fault ? 0 : limitForAge(options, input.age_s);
  sum = passiveSum(options, input, sum, state, result);
  // What holds the grip is as heavy as the grip, whatever people set of the surface.
  const DeviceN lift = liftOf(options, state.rise);
  const DeviceN wanted = (options.strength * state.rise) * sum + lift;
  const DeviceN command = finiteOrZero(wanted);

  // Rising is slow while forces come on; letting go is never held back by that.
  const bool gently = state.phase == EngagePhase::rising && norm(command) > norm(state.last);
  const double rate = gently ? options.engage_slew_n_per_s : options.contact_slew_n_per_s;
  DeviceN sent =
      finiteOrZero(capped(slewed(command, state.last, rate * input.dt_s), result.limit_n));
  if (zeroDemanded(options, input, state)) sent = {};
  state.last = sent;
  // A weight and what holds it are a potential of their own: what the surface gives is the rest.
  state.passivity = sentOut(state.passivity, sent == DeviceN{} ? sent : sent - lift);
  const bool deep = state.passivity.margin_mj <= -options.passivity.most_debt_mj;
  // A knock swings as it should; what is watched is the rest.
  const DeviceN watched =
      sent == DeviceN{} ? sent : sent - (options.strength * state.rise) * knocked;
  state.oscillation =
      watchOscillation(options.oscillation, {watched, input.hip, deep}, state.oscillation);
  result.force = sent;
  result.command_n = norm(command);
  result.limited = !(sent == wanted);
  result.state = state;
  return result;
}

}  // namespace relievo
