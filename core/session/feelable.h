// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/base/task.h"
#include "core/depth/depth_map.h"
#include "core/pyramid/pyramid.h"
#include "core/region/region.h"

namespace relievo {

/// What is asked of windows that are worth touching.
struct FeelOptions {
  double gain = 1;        ///< Heights are multiplied by it under the hand; > 0.
  double grip_factor = 4; /**< How much higher a bump must be for a hand that holds a grip than for
                               a bare fingertip; 3 to 5 is an estimate, nobody has measured it. */
  int most = 10;          ///< Windows, at most.
};

/// A window that is worth touching, and why. Shares are of the window's samples.
struct FeelableWindow {
  Region region;
  double score = 0;           ///< 0 .. 1; half where all relief is just felt.
  double felt_share = 0;      ///< Measured, not steep, and higher than what is just felt there.
  double steep_share = 0;     ///< Steeper under the hand than 60 degrees: felt as a wall.
  double measured_share = 0;  ///< The others are interpolated, on the base plane or outside.
  double width_mm = 0;        ///< Of the relief that is felt most clearly, on the object.
};

/// The height of a bump of that width that a bare fingertip just feels: 8 mm at 240 mm, growing
/// with the width's power of 1.3 (Louw, Kappers, Koenderink 2000); below 1 mm in proportion.
/// @param width_mm  > 0
double justFeltMm(double width_mm);

/// Windows of 200 samples of each level, and the whole map, whose relief a hand feels best, best
/// first. Relief is taken apart into widths (differences of Gaussians of each level); a sample
/// counts by the width at which it stands out most from what is just felt, with the scale at which
/// its window lies under the hand. Windows of one level overlap by a quarter at most.
/// [worker] @throw Cancelled @throw ArgumentError  gain, factor or number not above 0
std::vector<FeelableWindow> feelableWindows(const DepthMap& map, const Pyramid& pyramid,
                                            const FeelOptions& options, const Task& task = {});

}  // namespace relievo
