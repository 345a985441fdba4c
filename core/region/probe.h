// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "core/base/origin.h"
#include "core/base/vec3.h"

namespace relievo {

/// Where the hand is on the surface that is shown: proxy (blue) and HIP (red), for drawing and
/// text.
struct Probe {
  ViewMm proxy, hip;
  DeviceN force;  ///< On the hand, after all stages.
  double force_limit_n = 0;
  bool touching = false;
  bool forces_on = false;
  CellStatus origin = CellStatus::outside;  ///< Of the sample under the proxy.
  std::uint64_t window_id = 0;              ///< The window the positions belong to.
};

}  // namespace relievo
