// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace relievo {

/// One point of the two plots of a touch (paper, force figure).
struct ForcePoint {
  double t_s = 0;
  double hip_z_mm = 0, proxy_z_mm = 0;  ///< View mm.
  double force_n = 0;                   ///< Norm of the force on the hand.
};

}  // namespace relievo
