// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/base/vec3.h"

namespace relievo {

/// Reachable box of the device, centred on its origin; the default lies inside a 4 inch cube.
struct Workspace {
  DeviceMm half_extent{40, 40, 40};
};

}  // namespace relievo
