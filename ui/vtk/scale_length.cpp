// SPDX-License-Identifier: BSD-3-Clause
#include "ui/vtk/scale_length.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace relievo {

ScaleLength scaleLength(double at_most_mm) {
  const double decade = std::pow(10, std::floor(std::log10(at_most_mm) + 1e-9));
  double mm = decade;
  for (const double step : {2.0, 5.0}) {
    if (step * decade <= at_most_mm * (1 + 1e-9)) mm = step * decade;
  }
  struct Unit {
    double from_mm, mm;
    const char* name;
  };
  constexpr std::array<Unit, 5> kUnits{
      {{1e6, 1e6, "km"}, {1e3, 1e3, "m"}, {100, 10, "cm"}, {0.01, 1, "mm"}, {0, 1e-3, "\u00b5m"}}};
  for (const Unit& unit : kUnits) {
    if (mm < unit.from_mm * (1 - 1e-9)) continue;
    std::array<char, 48> text{};
    std::snprintf(text.data(), text.size(), "%.4g %s", mm / unit.mm, unit.name);
    return {mm, text.data()};
  }
  return {mm, {}};
}

double fittingMarkScale(double wanted, int width_px, int height_px) {
  constexpr double kSidePx = 180;  // Of the smallest view whose scale bar leaves most of it free.
  return std::min(wanted, std::max(1.0, std::min(width_px, height_px) / kSidePx));
}

}  // namespace relievo
