// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/force/passivity.h"

#include <algorithm>
#include <cmath>

namespace relievo {

namespace {
/// N along device axes times mm of hand: mJ.
double work(DeviceN force, DeviceMm way) RELIEVO_REALTIME {
  return force.x * way.x + force.y * way.y + force.z * way.z;
}
}  // namespace

// E(n) = E(n-1) - F . dx, less the change of what is stored; the sign: F acts on the hand.
PassivityState observe(const PassivityOptions& options, DeviceMm moved, double stored_mj,
                       PassivityState state) RELIEVO_REALTIME {
  if (state.started) {
    const int ago = std::clamp(options.force_delay_ticks, 0, 2);
    const double taken_mj = -work(state.sent[static_cast<std::size_t>(ago)], moved);
    const double margin = state.margin_mj + taken_mj - (stored_mj - state.stored_mj);
    state.margin_mj =
        std::isfinite(margin) ? std::clamp(margin, -options.most_debt_mj, options.reserve_mj) : 0;
  }
  state.stored_mj = std::isfinite(stored_mj) ? stored_mj : 0;
  state.started = true;
  return state;
}

DeviceN passivityForce(const PassivityOptions& options, const PassivityState& state,
                       DeviceMm velocity, double window_s, double dt_s) RELIEVO_REALTIME {
  const double speed = norm(velocity);
  if (!options.on || !(state.margin_mj < 0)) return {};
  if (!(speed > 0) || speed * window_s < options.position_step_mm) return {};
  // alpha = -E / (T v^2)
  const double wanted = -state.margin_mj / (dt_s * speed * speed);
  const double damping = std::min(wanted, options.most_damping_n_s_per_mm);
  return {-damping * velocity.x, -damping * velocity.y, -damping * velocity.z};
}

PassivityState sentOut(PassivityState state, DeviceN force) RELIEVO_REALTIME {
  for (std::size_t i = state.sent.size() - 1; i > 0; --i) state.sent[i] = state.sent[i - 1];
  state.sent[0] = force;
  return state;
}

PassivityState rebased(PassivityState state) RELIEVO_REALTIME {
  state.margin_mj = std::max(0.0, state.margin_mj);
  state.started = false;
  return state;
}

double springEnergyMj(double k, double length_mm, double most_n) RELIEVO_REALTIME {
  if (!(k > 0) || !(length_mm > 0)) return 0;
  const double bend_mm = most_n / k;  // Where the force stops growing.
  if (!(length_mm > bend_mm)) return 0.5 * k * length_mm * length_mm;
  return most_n * (length_mm - 0.5 * bend_mm);
}

}  // namespace relievo
