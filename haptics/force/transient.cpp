// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/force/transient.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace relievo {

namespace {
/// sin(2 pi 200 Hz t) at 1 kHz, and what is left after each tick of 6 ms.
constexpr std::array<double, 5> kSine{0, 0.95105651629515357, 0.58778525229247312,
                                      -0.58778525229247312, -0.95105651629515357};
constexpr double kLeftPerTick = 0.84648172489061413;  // exp(-1/6)

void begin(TransientState& state, DeviceMm normal, double size_n) RELIEVO_REALTIME {
  state.normal = normal;
  state.size_n = size_n;
  state.given_mj = 0;
  state.last_n = 0;
  state.age = 0;
}
}  // namespace

ContactTransient knock(const TransientOptions& options, const TransientInput& input,
                       TransientState state) RELIEVO_REALTIME {
  const bool lands = input.contact && !state.contact;
  const bool crosses = input.contact && state.contact && input.measured != state.measured;
  state.contact = input.contact;
  state.measured = input.measured;
  // What the hand did while it felt the last tick's share.
  state.given_mj += state.last_n * dot(input.moved, state.normal);
  state.last_n = 0;
  state.age = std::min(state.age + 1, kRefractoryTicks);
  if (state.age >= kRefractoryTicks) {
    const double against = -dot(input.velocity, input.normal);
    if (lands && options.contact_n > 0 && against > 0) {
      begin(state, input.normal, std::min(options.contact_n, options.contact_n_s_per_mm * against));
    } else if (crosses && options.crossing_n > 0) {
      begin(state, input.normal, options.crossing_n);
    }
  }
  ContactTransient result{{}, state};
  TransientState& now = result.state;
  if (now.age >= kKnockTicks || !(now.size_n > 0)) return result;
  if (!input.contact || now.given_mj > options.most_mj) {
    now.size_n = 0;  // Over.
    return result;
  }
  const double swing = kSine[static_cast<std::size_t>(now.age) % kSine.size()] *
                       std::pow(kLeftPerTick, now.age) * now.size_n;
  now.last_n = std::max(swing, -std::max(0.0, input.spring_n));
  result.force = {now.last_n * now.normal.x, now.last_n * now.normal.y, now.last_n * now.normal.z};
  return result;
}

}  // namespace relievo
