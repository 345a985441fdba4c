// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/loop/settings_blend.h"

#include <algorithm>
#include <cmath>

#include "haptics/proxy/texture.h"

namespace relievo {

namespace {
double between(double from, double to, double part) RELIEVO_REALTIME {
  return from + part * (to - from);
}

FeltSettings between(const FeltSettings& a, const FeltSettings& b, double part) RELIEVO_REALTIME {
  FeltSettings now = b;
  for (std::size_t i = 0; i < now.stiffness_n_per_mm.size(); ++i) {
    now.stiffness_n_per_mm[i] = between(a.stiffness_n_per_mm[i], b.stiffness_n_per_mm[i], part);
  }
  now.damping_n_s_per_mm = between(a.damping_n_s_per_mm, b.damping_n_s_per_mm, part);
  now.lift_n = between(a.lift_n, b.lift_n, part);
  now.static_friction = between(a.static_friction, b.static_friction, part);
  now.dynamic_friction = between(a.dynamic_friction, b.dynamic_friction, part);
  now.fields.softest_part = between(a.fields.softest_part, b.fields.softest_part, part);
  now.fields.texture_mm = between(a.fields.texture_mm, b.fields.texture_mm, part);
  now.fields.magnet_n = between(a.fields.magnet_n, b.fields.magnet_n, part);
  now.fields.magnet_reach_mm = between(a.fields.magnet_reach_mm, b.fields.magnet_reach_mm, part);
  now.strength = between(a.strength, b.strength, part);
  return now;
}

/// At most so many newtons lie between the two, at full rise.
double difference(const FeltSettings& a, const FeltSettings& b,
                  const FeltNow& now) RELIEVO_REALTIME {
  const double ka = stiffnessForDetail(now.detail, a.stiffness_n_per_mm);
  const double kb = stiffnessForDetail(now.detail, b.stiffness_n_per_mm);
  const double strength = std::max(a.strength, b.strength);
  const double pressed_n = std::max(ka, kb) * now.depth_mm;
  double sum = std::abs(a.lift_n - b.lift_n);  // Free and in contact.
  sum += std::abs(a.strength * ka - b.strength * kb) * now.depth_mm;
  const double rubs = std::max(std::abs(a.static_friction - b.static_friction),
                               std::abs(a.dynamic_friction - b.dynamic_friction));
  const double softens = std::abs(a.fields.softest_part - b.fields.softest_part);
  sum += strength * (rubs + softens) * pressed_n;
  if (now.depth_mm > 0) {
    sum += strength * std::abs(a.damping_n_s_per_mm - b.damping_n_s_per_mm) * now.speed_mm_per_s;
    // Rises by 2 between places that are half a cell of 0.4 mm apart; its slope pushes, twice.
    constexpr double kTextureNPerMm = kMostTextureN * 4 / 0.2;
    sum += strength * kTextureNPerMm * std::abs(a.fields.texture_mm - b.fields.texture_mm);
  } else {
    const double reach = std::max(a.fields.magnet_reach_mm, b.fields.magnet_reach_mm);
    const double reaches = std::abs(a.fields.magnet_reach_mm - b.fields.magnet_reach_mm);
    const double most_n = std::max(a.fields.magnet_n, b.fields.magnet_n);
    sum += strength * (std::abs(a.fields.magnet_n - b.fields.magnet_n) +
                       (reach > 0 ? 4 * most_n * reaches / reach : 0));
  }
  return sum;
}
}  // namespace

FeltSettings SettingsBlend::toward(const FeltSettings& asked, const FeltNow& now,
                                   bool surface_changes) RELIEVO_REALTIME {
  if (!started_) felt_ = asked;
  started_ = true;
  if (felt_ == asked) return felt_;
  FeltSettings next = asked;
  if (surface_changes) {
    next = felt_;
    next.strength = asked.strength;
  }
  const double whole_n = now.rise * difference(felt_, next, now);
  felt_ = whole_n <= kMostStepN || !(asked.strength > 0)
              ? next
              : between(felt_, next, kMostStepN / whole_n);
  return felt_;
}

}  // namespace relievo
