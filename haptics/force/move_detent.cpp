// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/force/move_detent.h"

#include <algorithm>
#include <cmath>

namespace relievo {

namespace {
using Detent = MoveDetent;

/// Toward the centre, `way_mm` >= 0 along a way.
double alongWay(double way_mm) RELIEVO_REALTIME {
  if (way_mm <= Detent::kClickMm) return Detent::kWayNPerMm * way_mm;
  const double top = Detent::kWayNPerMm * Detent::kClickMm;
  const double part =
      std::min(1.0, (way_mm - Detent::kClickMm) / (Detent::kClickedMm - Detent::kClickMm));
  return top + part * (Detent::kClickedN - top);
}

double wall(double way_mm) RELIEVO_REALTIME {
  const double in_mm = std::max(0.0, std::abs(way_mm) - Detent::kWallMm);
  return -std::copysign(std::min(Detent::kWallNPerMm * in_mm, Detent::kWallMostN), way_mm);
}

double across(double offset_mm) RELIEVO_REALTIME {
  return std::clamp(-Detent::kGuideNPerMm * offset_mm, -Detent::kGuideMostN, Detent::kGuideMostN);
}
}  // namespace

DeviceN detentForce(const MoveDetent& detent, DeviceMm hand) RELIEVO_REALTIME {
  if (!detent.on) return {};
  const DeviceMm away = hand - detent.centre;
  DeviceN force;
  // The longer side says which way it is.
  if (std::abs(away.x) >= std::abs(away.y)) {
    force.x = std::copysign(alongWay(std::abs(away.x)), -away.x);
    force.y = across(away.y);
  } else {
    force.x = across(away.x);
    force.y = std::copysign(alongWay(std::abs(away.y)), -away.y);
  }
  if ((detent.blocked & (away.x < 0 ? 1U : 2U)) != 0) force.x += wall(away.x);
  if ((detent.blocked & (away.y < 0 ? 4U : 8U)) != 0) force.y += wall(away.y);
  force.z = std::clamp(-Detent::kDepthNPerMm * away.z, -Detent::kDepthMostN, Detent::kDepthMostN);
  return force;
}

}  // namespace relievo
