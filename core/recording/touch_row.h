// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "core/base/origin.h"
#include "core/base/vec3.h"

namespace relievo {

/// One sample of a touch as recordings hold it; kLogColumns says what each member is called in
/// files.
struct TouchRow {
  double t_s = 0;          ///< Since the start of the recording, or on the stroke's clock.
  std::uint64_t tick = 0;  ///< Of the loop; a missing number was dropped.
  ViewMm hip{}, proxy{};   ///< On the object.
  DeviceN force{};         ///< On the hand, after all stages.
  double unlimited_n = 0;  ///< Size of the force before limits.
  bool clamped = false;    ///< A limit changed the force.
  CellStatus origin = CellStatus::outside;  ///< Of the cell under the proxy.
  bool contact = false;
  ViewMm normal{};  ///< Unit normal of the surface at the proxy.
  double stiffness_n_per_m = 0;
  std::uint64_t window_id = 0;
  int detail = 1;
  std::uint32_t buttons = 0;
  double rate_hz = 0;                 ///< Measured rate of the loop.
  DeviceMm hand_hip{}, hand_proxy{};  ///< In the hand's workspace.
  double age_s = 0;                   ///< Of the position.

  friend bool operator==(const TouchRow&, const TouchRow&) = default;
};

}  // namespace relievo
