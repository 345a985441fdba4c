// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <limits>

#include "haptics/record/stroke.h"

namespace relievo {

/// A simulated hand that is led, on a clock of exactly 1 kHz.
struct GuidedRun {
  DeviceMm start;                ///< Of a hand that gives way; one with a stroke begins there.
  const Stroke* wish = nullptr;  ///< What the person wants; null: to be led.
  double gives_way_s = 0.2;      ///< The aim of who wants to be led follows the hand in this time.
  double most_s = 120;           ///< It takes no longer.
};

/// How a hand was led.
struct GuidedFindings {
  GuideEnd end = GuideEnd::none;  ///< None: the time was over.
  double led_s = 0;
  double rms_mm = 0;     ///< Of its distance from the path, while it was led along it.
  double largest_n = 0;  ///< While it was led.
  ForceAudit audit;
};

/// Runs the core with a hand that is led, until the guide has let go for kAfterS.
/// @param space    what is touched
/// @param core     with GuideOptions::path of `path`; forces are on from the first tick
/// @param device   an open device that follows a wish and feels the force
/// @param each     called for every tick, with its time
/// @throw Cancelled
GuidedFindings runGuided(const HapticSpace& space, const HapticOptions& core, StrokeFrame frame,
                         const GuidePath& path, SteeredDevice& device, const GuidedRun& run,
                         const std::function<void(const HapticSample&, double t_s)>& each,
                         const Task& task = {});
inline constexpr double kAfterS = 0.5;

/// Of a place from a path, mm.
double distanceFromPath(const GuidePath& path, DeviceMm place);

}  // namespace relievo
