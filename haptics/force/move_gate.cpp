// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/force/move_gate.h"

#include <algorithm>
#include <cmath>

namespace relievo {

namespace {
using Gate = MoveGate;

/// Toward the centre, `way_mm` >= 0 along a way.
double alongWay(double way_mm) RELIEVO_REALTIME {
  if (way_mm <= Gate::kClickMm) return Gate::kWayNPerMm * way_mm;
  const double top = Gate::kWayNPerMm * Gate::kClickMm;
  const double part =
      std::min(1.0, (way_mm - Gate::kClickMm) / (Gate::kClickedMm - Gate::kClickMm));
  return top + part * (Gate::kClickedN - top);
}

double wall(double way_mm) RELIEVO_REALTIME {
  const double in_mm = std::max(0.0, std::abs(way_mm) - Gate::kWallMm);
  return -std::copysign(std::min(Gate::kWallNPerMm * in_mm, Gate::kWallMostN), way_mm);
}

double across(double offset_mm) RELIEVO_REALTIME {
  return std::clamp(-Gate::kGuideNPerMm * offset_mm, -Gate::kGuideMostN, Gate::kGuideMostN);
}
}  // namespace

DeviceN gateForce(const MoveGate& gate, DeviceMm hand) RELIEVO_REALTIME {
  if (!gate.on) return {};
  const DeviceMm away = hand - gate.centre;
  DeviceN force;
  // The longer side says which way it is.
  if (std::abs(away.x) >= std::abs(away.y)) {
    force.x = std::copysign(alongWay(std::abs(away.x)), -away.x);
    force.y = across(away.y);
  } else {
    force.x = across(away.x);
    force.y = std::copysign(alongWay(std::abs(away.y)), -away.y);
  }
  if ((gate.blocked & (away.x < 0 ? 1U : 2U)) != 0) force.x += wall(away.x);
  if ((gate.blocked & (away.y < 0 ? 4U : 8U)) != 0) force.y += wall(away.y);
  force.z = std::clamp(-Gate::kDepthNPerMm * away.z, -Gate::kDepthMostN, Gate::kDepthMostN);
  return force;
}

}  // namespace relievo
