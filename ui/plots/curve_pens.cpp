// SPDX-License-Identifier: BSD-3-Clause
#include "ui/plots/curve_pens.h"

#include <string_view>

#include "ui/language/core_text.h"
#include "ui/style/palette.h"

namespace relievo {
namespace {

QPen penOf(const ThemeColours& colours, const ForceCurve& curve) {
  const Qt::PenStyle style = curve.dashed ? Qt::DashLine : Qt::SolidLine;
  switch (curve.ink) {
    case CurveInk::hand:
      return {colours.hip, 1.5, style};
    case CurveInk::proxy:
      return {colours.proxy, 1.8, style};
    case CurveInk::force:
      break;
  }
  return {colours.force, 1.8, style};
}

}  // namespace

QStringList curveNames(ForceStrip strip) {
  QStringList names;
  for (const ForceCurve& curve : kForceCurves) {
    if (curve.strip == strip) names += coreText(std::string_view(curve.window_name));
  }
  return names;
}

QVector<QPen> curvePens(ForceStrip strip, const ThemeColours& colours) {
  QVector<QPen> pens;
  for (const ForceCurve& curve : kForceCurves) {
    if (curve.strip == strip) pens += penOf(colours, curve);
  }
  return pens;
}

}  // namespace relievo
