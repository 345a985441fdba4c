// SPDX-License-Identifier: BSD-3-Clause
#include "ui/figure/figure_plot.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/axis.h"
#include "core/recording/force_curves.h"

namespace relievo {
namespace {

constexpr std::size_t kMostPoints = 4000;  // A curve; a longer one is thinned by min and max.
const QColor kGrid(0xd8, 0xd8, 0xd8);
const QColor kHip(0xd0, 0x20, 0x20);
const QColor kProxy(0x1f, 0x5f, 0xd0);

constexpr int kMostSteps = 4;
constexpr double kTitleEm = 3.9;  // From a plot's left side to the baseline of its upright title.
constexpr double kRoomEm = 1.1;   // Beyond that baseline.

QString tick(double value, double step) {
  return QString::fromStdString(tickText(value, step));
}

double widestNumber(const FigureInk& ink, const Axis& axis) {
  double widest = 0;
  for (double v = axis.low; v <= axis.high + 0.5 * axis.step; v += axis.step) {
    widest = std::max(widest, ink.width(tick(v, axis.step)));
  }
  return widest;
}

/// How far left of the plot its upright title stands, pixels: beside the widest number.
double titlePx(const FigureInk& ink, const Axis& y) {
  const double em = ink.pt(ink.textPt());
  return std::max(kTitleEm * em, widestNumber(ink, y) + ink.pt(3) + 0.5 * em);
}

/// The last number of an axis whose ends are exact, and where it stands.
double lastNumber(const Axis& x) {
  return std::floor(x.high / x.step + 1e-9) * x.step;
}

/// A time axis whose numbers stand beside each other over `across` pixels.
Axis timeAxis(const FigureInk& ink, double low, double high, double across) {
  for (int steps = kMostSteps;; --steps) {
    const Axis axis = axisFor(low, high, steps, AxisEnds::exact);
    const double number = std::max(ink.width(tick(axis.low, axis.step)),
                                   ink.width(tick(lastNumber(axis), axis.step)));
    const double apart = axis.step / (axis.high - axis.low) * across;
    if (steps == 1 || apart >= number + 0.5 * ink.pt(ink.textPt())) return axis;
  }
}

/// The box of a plot whose numbers and title have room within `paper`.
QRectF trimmed(const FigureInk& ink, const QRectF& paper, const Axis& x, double left_px) {
  const double mm_per_px = 1 / ink.px(1.0);
  const double half = 0.5 * ink.width(tick(lastNumber(x), x.step));
  QRectF box = paper;
  box.setLeft(paper.left() + left_px * mm_per_px);
  const double aside = (x.high - lastNumber(x)) / (x.high - x.low) * ink.px(box.width());
  box.setRight(paper.right() - std::max(0.0, half - aside) * mm_per_px);
  return box;
}

class Plot {
 public:
  Plot(FigureInk& ink, const QRectF& paper, Axis x, Axis y)
      : ink_(ink), box_(ink.px(paper)), x_(x), y_(y) {}

  QPointF at(double x, double y) const {
    return {box_.left() + (x - x_.low) / (x_.high - x_.low) * box_.width(),
            box_.bottom() - (y - y_.low) / (y_.high - y_.low) * box_.height()};
  }

  void frame(const QString& y_title, const QString& x_title) {
    QPainter& painter = ink_.painter();
    const double gap = ink_.pt(3);
    const double half = 0.35 * ink_.pt(ink_.textPt());
    painter.setPen(ink_.pen(kGrid, 0.5));
    for (double v = y_.low; v <= y_.high + 0.5 * y_.step; v += y_.step) {
      const QPointF p = at(x_.low, v);
      painter.drawLine(p, QPointF(box_.right(), p.y()));
      ink_.text(p + QPointF(-gap, half), tick(v, y_.step), Qt::AlignRight);
    }
    for (double t = std::ceil(x_.low / x_.step - 1e-9) * x_.step; t <= x_.high + 1e-9 * x_.step;
         t += x_.step) {
      const QPointF p = at(t, y_.low);
      painter.drawLine(p, QPointF(p.x(), box_.top()));
      if (!x_title.isEmpty()) {
        ink_.text(p + QPointF(0, ink_.lineHeight()), tick(t, x_.step), Qt::AlignHCenter);
      }
    }
    painter.setBrush(Qt::NoBrush);
    painter.setPen(ink_.pen(kInk, 0.6));
    painter.drawRect(box_);
    ink_.uprightText({box_.left() - titlePx(ink_, y_), box_.center().y()}, y_title);
    if (x_title.isEmpty()) return;
    ink_.text({box_.center().x(), box_.bottom() + 2.1 * ink_.lineHeight()}, x_title,
              Qt::AlignHCenter);
  }

  void curve(const std::vector<QPointF>& points, const QPen& pen) {
    QPolygonF line;
    const std::size_t bin = std::max<std::size_t>(1, 2 * points.size() / kMostPoints);
    for (std::size_t i = 0; i < points.size(); i += bin) {
      const auto from = points.begin() + static_cast<std::ptrdiff_t>(i);
      const auto to =
          points.begin() + static_cast<std::ptrdiff_t>(std::min(i + bin, points.size()));
      auto [low, high] = std::minmax_element(
          from, to, [](const QPointF& a, const QPointF& b) { return a.y() < b.y(); });
      if (low->x() > high->x()) std::swap(low, high);
      line << at(low->x(), low->y());
      if (low != high) line << at(high->x(), high->y());
    }
    QPainter& painter = ink_.painter();
    painter.save();
    painter.setClipRect(box_);
    painter.setPen(pen);
    painter.drawPolyline(line);
    painter.restore();
  }

  /// Words at the upper right, the pen before them.
  void name(const QString& words, const QPen& pen, double lines_down) {
    const double y = box_.top() + (lines_down + 0.9) * ink_.lineHeight();
    const double right = box_.right() - ink_.pt(4);
    const double left = right - ink_.width(words);
    ink_.painter().fillRect(QRectF(left - ink_.pt(24), y - 0.75 * ink_.lineHeight(),
                                   right - left + ink_.pt(26), ink_.lineHeight()),
                            kPlate);
    ink_.text({left, y}, words);
    ink_.painter().setPen(pen);
    const double middle = y - 0.3 * ink_.pt(ink_.textPt());
    ink_.painter().drawLine(QPointF(left - ink_.pt(22), middle),
                            QPointF(left - ink_.pt(4), middle));
  }

 private:
  FigureInk& ink_;
  QRectF box_;
  Axis x_, y_;
};

std::pair<double, double> range(const std::vector<QPointF>& points) {
  const auto [low, high] =
      std::minmax_element(points.begin(), points.end(),
                          [](const QPointF& a, const QPointF& b) { return a.y() < b.y(); });
  return {low->y(), high->y()};
}

std::vector<QPointF> curveOf(const std::vector<ForcePoint>& rows, double ForcePoint::*value) {
  std::vector<QPointF> curve;
  curve.reserve(rows.size());
  for (const ForcePoint& row : rows) curve.emplace_back(row.t_s, row.*value);
  return curve;
}

/// Lowest and highest value of a strip's curves.
std::pair<double, double> rangeOf(const std::vector<ForcePoint>& rows, ForceStrip strip) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const ForceCurve& curve : kForceCurves) {
    if (curve.strip != strip) continue;
    for (const ForcePoint& row : rows) {
      low = std::min(low, row.*curve.value);
      high = std::max(high, row.*curve.value);
    }
  }
  return {low, high};
}

/// Width and dashes tell the curves apart without colour, too.
QPen penOf(const FigureInk& ink, const ForceCurve& curve) {
  const auto pen = [&] {
    switch (curve.ink) {
      case CurveInk::hand:
        return ink.pen(kHip, 0.9);
      case CurveInk::proxy:
        return ink.pen(kProxy, 1.4);
      case CurveInk::force:
        break;
    }
    return ink.pen(kInk, 1);
  };
  QPen chosen = pen();
  if (curve.dashed) chosen.setDashPattern({4, 2});
  return chosen;
}

/// Curves, and their names if a strip has several.
void drawStrip(const FigureInk& ink, Plot& plot, const std::vector<ForcePoint>& rows,
               ForceStrip strip) {
  for (std::size_t i = kForceCurves.size(); i-- > 0;) {
    const ForceCurve& curve = kForceCurves[i];
    if (curve.strip == strip) plot.curve(curveOf(rows, curve.value), penOf(ink, curve));
  }
  double lines_down = 0;
  for (std::size_t i = kForceCurves.size(); i-- > 0;) {
    const ForceCurve& curve = kForceCurves[i];
    if (curve.strip != strip || curvesIn(strip) < 2) continue;
    const QString name =
        QString::fromLatin1(curve.paper_name.data(), static_cast<int>(curve.paper_name.size()));
    plot.name(name, penOf(ink, curve), lines_down++);
  }
}

}  // namespace

ForcePlots drawForcePlots(FigureInk& ink, const std::vector<ForcePoint>& rows,
                          const ForcePlots& papers) {
  const auto [lowest, highest] = rangeOf(rows, ForceStrip::heights);
  const Axis z = axisFor(lowest, highest, kMostSteps);
  const Axis n = axisFor(0, rangeOf(rows, ForceStrip::forces).second, kMostSteps);
  const double left = std::max(titlePx(ink, z), titlePx(ink, n)) + kRoomEm * ink.pt(ink.textPt());
  const Axis time =
      timeAxis(ink, rows.front().t_s, rows.back().t_s, ink.px(papers.heights.width()) - left);
  const ForcePlots boxes{trimmed(ink, papers.heights, time, left),
                         trimmed(ink, papers.forces, time, left)};
  Plot above(ink, boxes.heights, time, z);
  above.frame(QStringLiteral("z (mm)"), {});
  drawStrip(ink, above, rows, ForceStrip::heights);
  Plot below(ink, boxes.forces, time, n);
  below.frame(QStringLiteral("force (N)"), QStringLiteral("time (s)"));
  drawStrip(ink, below, rows, ForceStrip::forces);
  return boxes;
}

void drawCurve(FigureInk& ink, const std::vector<std::vector<QPointF>>& pieces, const QRectF& box,
               const QString& x_title, const QString& y_title) {
  if (pieces.empty()) return;
  auto [low, high] = range(pieces.front());
  for (const std::vector<QPointF>& piece : pieces) {
    const auto [lowest, highest] = range(piece);
    low = std::min(low, lowest);
    high = std::max(high, highest);
  }
  const double from = pieces.front().front().x(), to = pieces.back().back().x();
  Plot plot(ink, box, axisFor(from, to, kMostSteps, AxisEnds::exact),
            axisFor(low, high, kMostSteps));
  plot.frame(y_title, x_title);
  for (const std::vector<QPointF>& piece : pieces) plot.curve(piece, ink.pen(kProxy, 1.2));
}

}  // namespace relievo
