// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/loop/surface_fields.h"

#include <algorithm>
#include <cmath>

#include "haptics/proxy/slide.h"
#include "haptics/proxy/surface.h"
#include "haptics/proxy/texture.h"

namespace relievo {

namespace {
/// Slopes of a potential over the proxy's place (x, y), N.
struct Push {
  double x = 0, y = 0;
};

/// A slope over the proxy's place becomes one over the hand's by the way in which the proxy follows
/// the hand: dp = H^-1 (I | grad f) dh, H the Hessian of the squared distance
/// (haptics/proxy/slide.h). Over a crease the proxy does not follow at all.
DeviceN atTheHand(const HapticSpace& space, const ProxyState& proxy, Push push) RELIEVO_REALTIME {
  const GridPoint p = proxy.position, e = p - proxy.hip;
  return onSurface(space, [&](const auto& surface) RELIEVO_REALTIME {
    const auto patch = surface.patch(p.x, p.y, 0, 0);
    const Jet jet = patch.jet(p.x, p.y);
    Slope slope = slopeOf(jet, e);
    const bool smooth = surface.runsOn(patch, p.x, p.y);
    const bool fixed_x = !smooth && surface.onLineX(p.x), fixed_y = !smooth && surface.onLineY(p.y);
    double x = 0, y = 0;
    if (fixed_x && fixed_y) return DeviceN{};
    if (fixed_x) {
      y = -newtonAlong(push.y, slope.h22, slope.m22);
    } else if (fixed_y) {
      x = -newtonAlong(push.x, slope.h11, slope.m11);
    } else {
      slope.gx = push.x;
      slope.gy = push.y;
      const Descent down = newton(slope);
      x = -down.dx;
      y = -down.dy;
    }
    return DeviceN{x, y, jet.fx * x + jet.fy * y};
  });
}

/// Work of pressing that a texture of `rise_mm` takes, T(d) per mm of rise: k d at first, no more
/// than what keeps the texture softer than kMostTextureStiffness.
struct Pressing {
  double t_n = 0, slope_n_per_mm = 0;
};
Pressing pressing(double k, double depth_mm, double place_mm, double most_mm) RELIEVO_REALTIME {
  // A quadratic B-spline of numbers within +-a bends by at most 4 a / place^2 along each axis.
  const double most_n =
      std::min(kMostTextureN, kMostTextureStiffness * place_mm * place_mm / (4 * most_mm));
  const double left = std::exp(-k * depth_mm / most_n);
  return {most_n * (1 - left), k * left};
}

Fields inContact(const HapticSpace& space, const ProxyState& proxy, GridPoint held, double k,
                 const ProxyOptions& follow, const FieldOptions& options) RELIEVO_REALTIME {
  Fields fields;
  const GridPoint p = proxy.position, out = p - held;
  const double cell_mm = space.deviceMmPerCell(), depth = cell_mm * norm(out);
  // A proxy that friction holds does not follow the hand.
  const bool follows = !(follow.static_friction > 0) || proxy.slides;
  Push soft, push;
  if (options.softest_part < 1) {
    const MapValue firm = firmnessAt(space, p.x, p.y);
    const double range = 1 - options.softest_part;
    fields.part = options.softest_part + range * firm.value;
    const double stored = 0.5 * k * depth * depth * range;
    soft = {stored * firm.along_x, stored * firm.along_y};
  }
  if (options.texture_mm > 0 && space.texture.present) {
    const MapValue rise = textureAt(space, p.x, p.y, options.texture_mm);
    const Pressing t = pressing(k, depth, 0.5 * cell_mm, options.texture_mm);
    push = {t.t_n * rise.along_x, t.t_n * rise.along_y};
    fields.energy_mj = t.t_n * rise.value;
    const double along = t.slope_n_per_mm * rise.value;
    if (depth > 0) {
      const double n = along * cell_mm / depth;
      fields.force = {n * out.x, n * out.y, n * out.z};
    }
  }
  if (follows && (push.x != 0 || push.y != 0)) {
    fields.force = fields.force - atTheHand(space, proxy, push);
  }
  if (follows && (soft.x != 0 || soft.y != 0)) {
    fields.soft = -1.0 * atTheHand(space, proxy, soft);
    fields.force = fields.force + fields.soft;
  }
  return fields;
}

/// V rises from 0 at the surface to 2/3 of `most` times the reach: no pull at either end.
Fields above(const HapticSpace& space, const ProxyState& proxy,
             const FieldOptions& options) RELIEVO_REALTIME {
  Fields fields;
  if (!(options.magnet_n > 0)) return fields;
  const double reach = options.magnet_reach_mm;
  const GridPoint p = proxy.position;
  const Jet jet = surfaceJet(space, p.x, p.y);
  const double gap = space.deviceMmPerCell() * (p.z - jet.f);
  if (!(gap > 0)) return fields;
  const double part = std::min(1.0, gap / reach);
  fields.energy_mj = options.magnet_n * reach * part * part * (2 - 4 * part / 3);
  const double pull = 4 * options.magnet_n * part * (1 - part);
  fields.force = {pull * jet.fx, pull * jet.fy, -pull};
  const double size =
      norm(fields.force);  // Beside a wall the gap shrinks faster than the hand goes.
  if (size > options.magnet_n) fields.force = (options.magnet_n / size) * fields.force;
  return fields;
}
}  // namespace

Fields fieldsAt(const HapticSpace& space, const ProxyState& proxy, GridPoint held, double k,
                const ProxyOptions& follow, const FieldOptions& options) RELIEVO_REALTIME {
  return proxy.contact ? inContact(space, proxy, held, k, follow, options)
                       : above(space, proxy, options);
}

Fields blended(const Fields& was, const Fields& now, double weight) RELIEVO_REALTIME {
  const double rest = 1 - weight;
  return {weight * now.part + rest * was.part, weight * now.force + rest * was.force,
          weight * now.energy_mj + rest * was.energy_mj, weight * now.soft + rest * was.soft};
}

}  // namespace relievo
