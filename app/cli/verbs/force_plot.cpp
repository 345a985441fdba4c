// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/verbs/force_plot.h"

#include <algorithm>
#include <array>

#include "app/cli/verbs/svg.h"
#include "core/base/failure.h"
#include "core/recording/force_curves.h"
#include "haptics/device/falcon/link/link.h"

namespace relievo::batch {
namespace {

constexpr double kWidth = 640;  // SVG units; text is 11 of them high.
constexpr double kLeft = 64;
constexpr double kRight = 16;
constexpr std::size_t kMostPoints = 4000;  // Per curve; a longer stroke is thinned by min and max.

/// One diagram: a box with grid lines, labels and curves.
class Panel {
 public:
  Panel(double top, double height, Axis time, Axis value)
      : top_(top), height_(height), time_(time), value_(value) {}

  double x(double t) const {
    return kLeft + (t - time_.low) / (time_.high - time_.low) * (kWidth - kLeft - kRight);
  }
  double y(double v) const {
    return top_ + height_ * (1 - (v - value_.low) / (value_.high - value_.low));
  }

  std::string frame(const std::string& label, bool with_time) const {
    std::string svg;
    for (double v = value_.low; v <= value_.high + 0.5 * value_.step; v += value_.step) {
      svg += lineAt(kLeft, y(v), kWidth - kRight, y(v), "#dddddd");
      svg += textAt(kLeft - 6, y(v) + 4, "end", tickText(v, value_.step));
    }
    for (double t = time_.low; t <= time_.high + 0.5 * time_.step; t += time_.step) {
      svg += lineAt(x(t), top_, x(t), top_ + height_, "#dddddd");
      if (with_time) svg += textAt(x(t), top_ + height_ + 16, "middle", tickText(t, time_.step));
    }
    const double middle = top_ + 0.5 * height_;
    svg += textAt(16, middle, "middle", label,
                  " transform='rotate(-90 16 " + fixedDigits(middle, 1) + ")'");
    return svg;
  }

  /// A dashed line across at a value, with its name; nothing where the diagram does not reach it.
  std::string mark(double value, const std::string& name) const {
    if (value < value_.low || value > value_.high) return {};
    const double at = y(value);
    return "<line x1='" + fixedDigits(kLeft, 1) + "' y1='" + fixedDigits(at, 1) + "' x2='" +
           fixedDigits(kWidth - kRight, 1) + "' y2='" + fixedDigits(at, 1) +
           "' stroke='#d02020' stroke-width='1.2' stroke-dasharray='8 4'/>\n" +
           textAt(kLeft + 4, at - 4, "start", name, " fill='#d02020'");
  }

  std::string curve(const std::vector<ForcePoint>& rows, double ForcePoint::*value,
                    const std::string& style) const {
    std::string svg = "<polyline fill='none' " + style + " points='";
    const std::size_t bin = std::max<std::size_t>(1, 2 * rows.size() / kMostPoints);
    for (std::size_t i = 0; i < rows.size(); i += bin) {
      const auto first = rows.begin() + static_cast<std::ptrdiff_t>(i);
      const auto last = rows.begin() + static_cast<std::ptrdiff_t>(std::min(i + bin, rows.size()));
      auto [low, high] = std::minmax_element(
          first, last,
          [&](const ForcePoint& a, const ForcePoint& b) { return a.*value < b.*value; });
      if (low->t_s > high->t_s) std::swap(low, high);
      svg += fixedDigits(x(low->t_s), 2) + "," + fixedDigits(y((*low).*value), 2) + " ";
      if (low != high)
        svg += fixedDigits(x(high->t_s), 2) + "," + fixedDigits(y((*high).*value), 2) + " ";
    }
    return svg + "'/>\n";
  }

 private:
  double top_, height_;
  Axis time_, value_;
};

Axis rangeOf(const std::vector<ForcePoint>& rows, ForceStrip strip) {
  double low = 1e300;
  double high = -1e300;
  for (const ForceCurve& curve : kForceCurves) {
    if (curve.strip != strip) continue;
    for (const ForcePoint& row : rows) {
      low = std::min(low, row.*curve.value);
      high = std::max(high, row.*curve.value);
    }
  }
  return axisFor(low, high);
}

struct Ink {
  const char* colour;
  const char* width;
};
constexpr Ink inkOf(CurveInk ink) {
  constexpr std::array<Ink, 3> kInks{{{"#d02020", "1.3"}, {"#1f5fd0", "2"}, {"#222222", "1.5"}}};
  return kInks.at(static_cast<std::size_t>(ink));
}

/// Dashes and width tell the curves apart without colour, too.
std::string styleOf(const ForceCurve& curve) {
  const Ink ink = inkOf(curve.ink);
  return std::string("stroke='") + ink.colour + "' stroke-width='" + ink.width + "'" +
         (curve.dashed ? " stroke-dasharray='5 2'" : "");
}

std::string curvesOf(const Panel& panel, const std::vector<ForcePoint>& rows, ForceStrip strip) {
  std::string svg;
  for (std::size_t i = kForceCurves.size(); i-- > 0;) {
    const ForceCurve& curve = kForceCurves[i];
    if (curve.strip == strip) svg += panel.curve(rows, curve.value, styleOf(curve));
  }
  return svg;
}

/// Their names, from the right; a curve that is alone needs none.
std::string namesOf(ForceStrip strip, double y) {
  constexpr double kPerLetter = 6, kGap = 12;
  std::string svg;
  double right = kWidth - kRight - 4;
  for (const ForceCurve& curve : kForceCurves) {
    if (curve.strip != strip || curvesIn(strip) < 2) continue;
    svg += textAt(right, y, "end", std::string(curve.paper_name),
                  std::string(" fill='") + inkOf(curve.ink).colour + "'");
    right -= kPerLetter * static_cast<double>(curve.paper_name.size()) + kGap;
  }
  return svg;
}

}  // namespace

ForceLimit falconLimit() {
  return {"Falcon", falcon::LinkLimits{}.max_force_n};
}

std::string forcePlotSvg(const std::vector<ForcePoint>& rows, const std::string& title,
                         const ForceLimit& limit) {
  if (rows.empty()) throw failure<MessageId::stroke_without_ticks>();
  Axis time = axisFor(rows.front().t_s, rows.back().t_s);
  time.high = std::max(rows.back().t_s, time.low + 1e-3);
  const Panel heights(36, 200, time, rangeOf(rows, ForceStrip::heights));
  const Panel forces(260, 140, time, rangeOf(rows, ForceStrip::forces));

  std::string svg =
      "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 640 450' width='640' "
      "height='450' font-family='sans-serif' font-size='11'>\n"
      "<rect width='640' height='450' fill='white'/>\n";
  svg += textAt(kLeft, 22, "start", escaped(title), " font-size='13'");
  svg += heights.frame("z (mm)", false);
  svg += forces.frame("force (N)", true);
  svg += textAt(0.5 * (kLeft + kWidth - kRight), 438, "middle", "time (s)");
  svg += curvesOf(heights, rows, ForceStrip::heights);
  svg += curvesOf(forces, rows, ForceStrip::forces);
  if (limit.force_n > 0) {
    svg += forces.mark(limit.force_n,
                       escaped(limit.device) + " at most " + tickText(limit.force_n, 0.1) + " N");
  }
  svg += namesOf(ForceStrip::heights, 50) + namesOf(ForceStrip::forces, 274);
  return svg + "</svg>\n";
}

}  // namespace relievo::batch
