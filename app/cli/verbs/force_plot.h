// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "core/recording/force_curve.h"

namespace relievo::batch {

/// The largest force of a device: what is beyond it no hand has felt.
struct ForceLimit {
  std::string device;
  double force_n = 0;  ///< 0: none is drawn.
};

/// The Falcon's, which a hand might hold where there is no device.
ForceLimit falconLimit();

/// The paper's force figure as SVG: z of HIP (red) and proxy (blue) above, force below, against
/// time. Text stays text, lines stay lines.
/// @param limit  a dashed line, where the forces reach it
std::string forcePlotSvg(const std::vector<ForcePoint>& rows, const std::string& title,
                         const ForceLimit& limit = {});

}  // namespace relievo::batch
