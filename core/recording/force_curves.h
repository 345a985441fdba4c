// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>

#include "core/recording/force_point.h"

namespace relievo {

/// The two diagrams of a touch, one above or beside the other; each with one unit.
enum class ForceStrip : std::uint8_t { heights, forces };
inline constexpr std::array kForceStrips{ForceStrip::heights, ForceStrip::forces};

/// Whose colour a curve has; each drawing knows its own three.
enum class CurveInk : std::uint8_t { hand, proxy, force };

/// One curve of the plots of a touch: of the window, of the oscilloscope, of figures and videos,
/// and of `relievo touch --plot`.
struct ForceCurve {
  double ForcePoint::*value;  ///< mm or N, as the strip.
  ForceStrip strip;
  CurveInk ink;
  bool dashed;                  ///< Tells it from its neighbours without colour, too.
  std::string_view paper_name;  ///< In figures, beside others of its strip.
  const char* window_name;      ///< English; ui shows it in its own language.
  std::string_view column;      ///< Of the tables that the oscilloscope saves.
};

// Marks a text that ui/translations/update is to show to translators.
#define RELIEVO_CURVE_NAME(text) text

/// All of them. On paper those that come first are drawn last, over the others.
inline constexpr auto kForceCurves = std::to_array<ForceCurve>({
    {&ForcePoint::hip_z_mm, ForceStrip::heights, CurveInk::hand, true, "HIP",
     RELIEVO_CURVE_NAME("HIP"), "hip_z_mm"},
    {&ForcePoint::proxy_z_mm, ForceStrip::heights, CurveInk::proxy, false, "proxy",
     RELIEVO_CURVE_NAME("proxy"), "proxy_z_mm"},
    {&ForcePoint::force_n, ForceStrip::forces, CurveInk::force, false, "force",
     RELIEVO_CURVE_NAME("force"), "f_N"},
});

#undef RELIEVO_CURVE_NAME

constexpr auto curvesIn(ForceStrip strip) {
  return std::count_if(kForceCurves.begin(), kForceCurves.end(),
                       [&](const ForceCurve& curve) { return curve.strip == strip; });
}

}  // namespace relievo
