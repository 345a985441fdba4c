// SPDX-License-Identifier: BSD-3-Clause
#include "ui/figure/figure_marks.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <QPainterPath>
#include <tuple>
#include <vector>

#include "core/base/axis.h"
#include "core/measure/measure_text.h"
#include "core/project/caption.h"
#include "core/project/shown_lengths.h"
#include "ui/vtk/scale_length.h"

namespace relievo {
namespace {

const QColor kWindowPink(0xff, 0x4f, 0xa3);
const QColor kWindowRim(40, 12, 26);
const QColor kHatchDark(46, 52, 64), kHatchLight(246, 246, 242);
const QColor kHatchedStone(206, 205, 202), kHatchedPlane(176, 178, 182);
constexpr double kInsetPt = 3;  // Of marks from the picture's edge.

QString text(double value, int digits = 3) {
  return QString::fromStdString(shortNumber(value, digits));
}

/// One panel on paper: from the object's millimetres to the paper's pixels.
class PanelSpace {
 public:
  PanelSpace(const FigureInk& ink, const FigurePanel& panel)
      : box_(ink.pixels(panel.paper)), shown_(panel.shown) {
    mm_per_px_ = std::max(shown_.width_mm / box_.width(), shown_.height_mm / box_.height());
  }
  const QRectF& box() const { return box_; }
  double mmPerPx() const { return mm_per_px_; }
  QPointF at(double x_mm, double y_mm) const {
    const double right = x_mm - shown_.x_mm - 0.5 * shown_.width_mm;
    const double up = y_mm - shown_.y_mm - 0.5 * shown_.height_mm;
    return box_.center() + QPointF(right, -up) / mm_per_px_;
  }

 private:
  QRectF box_;
  RectMm shown_;
  double mm_per_px_ = 1;
};

void plate(FigureInk& ink, const QRectF& box) {
  ink.painter().fillRect(box, kPlate);
}

// The bar's ends lie on whole pixels; its length is off by half a pixel at most.
QRectF scaleBar(FigureInk& ink, const PanelSpace& space) {
  const double inset = ink.pt(kInsetPt);
  const ScaleLength length = scaleLength(0.25 * space.box().width() * space.mmPerPx());
  const double bar = std::round(length.mm / space.mmPerPx());
  const QString label = QString::fromStdString(length.label);
  const double width = std::max(bar, ink.width(label)) + 2 * inset;
  const double thick = std::max(1.0, std::round(ink.pt(1.6)));
  const double height = ink.lineHeight() + thick + 2.2 * inset;
  const QRectF box(space.box().left() + inset, space.box().bottom() - inset - height, width,
                   height);
  plate(ink, box);
  const double x = std::round(box.left() + 0.5 * (width - bar));
  const double y = std::round(box.bottom() - inset - thick);
  ink.painter().fillRect(QRectF(x, y, bar, thick), kInk);
  ink.text({x + 0.5 * bar, y - 0.8 * inset}, label, Qt::AlignHCenter);
  return box;
}

/// The relief's height at the picture's own scale, upright.
QRectF heightBar(FigureInk& ink, const PanelSpace& space, double range_mm) {
  const double most = std::min(range_mm, 0.22 * space.box().height() * space.mmPerPx());
  if (!(most > 0)) return {};
  const ScaleLength length = scaleLength(most);
  const double bar = std::round(length.mm / space.mmPerPx());
  if (bar < ink.pt(2)) return {};  // Too flat to be drawn at this scale.
  const double inset = ink.pt(kInsetPt);
  const QString label = QStringLiteral("height %1").arg(QString::fromStdString(length.label));
  const double thick = std::max(1.0, std::round(ink.pt(1.6)));
  const double width = ink.width(label) + thick + 3 * inset;
  const double height = std::max(bar, ink.lineHeight()) + 2 * inset;
  const QRectF box(space.box().right() - inset - width, space.box().bottom() - inset - height,
                   width, height);
  plate(ink, box);
  const double bottom = std::round(box.bottom() - inset);
  ink.painter().fillRect(QRectF(std::round(box.right() - inset - thick), bottom - bar, thick, bar),
                         kInk);
  ink.text({box.left() + inset, box.center().y() + 0.35 * ink.pt(ink.textPt())}, label);
  return box;
}

/// Which file axis points up: north where the data are a map.
QString upName(const Surface& surface) {
  const auto& m = surface.view_from_file.m;
  std::size_t axis = 0;
  for (std::size_t k = 1; k < 3; ++k) {
    if (std::abs(m[4 + k]) > std::abs(m[4 + axis])) axis = k;
  }
  const double length = std::hypot(m[4], m[5], m[6]);
  if (std::abs(m[4 + axis]) < 0.999 * length) return QStringLiteral("up");
  const bool map =
      surface.info.format.rfind("LAS", 0) == 0 || surface.info.format.rfind("GTiff", 0) == 0;
  if (map && axis == 1 && m[5] > 0) return QStringLiteral("N");
  const char letter = "xyz"[axis];
  return (m[4 + axis] < 0 ? QStringLiteral("\u2212%1") : QStringLiteral("%1")).arg(letter);
}

QRectF upMark(FigureInk& ink, const PanelSpace& space, const QString& name) {
  const double inset = ink.pt(kInsetPt);
  const double arrow = ink.pt(1.6 * ink.textPt());
  const double width = std::max(ink.width(name), 0.6 * arrow) + 2 * inset;
  const QRectF box(space.box().right() - inset - width, space.box().top() + inset, width,
                   arrow + ink.lineHeight() + inset);
  plate(ink, box);
  const QPointF tip(box.center().x(), box.top() + 0.6 * inset);
  QPainterPath head;
  head.moveTo(tip);
  head.lineTo(tip + QPointF(-0.28 * arrow, 0.6 * arrow));
  head.lineTo(tip + QPointF(0, 0.45 * arrow));
  head.lineTo(tip + QPointF(0.28 * arrow, 0.6 * arrow));
  head.closeSubpath();
  ink.painter().fillPath(head, kInk);
  ink.painter().setPen(ink.pen(kInk, 0.8));
  ink.painter().drawLine(tip + QPointF(0, 0.4 * arrow), tip + QPointF(0, arrow));
  ink.text({box.center().x(), box.bottom() - inset}, name, Qt::AlignHCenter);
  return box;
}

void outline(FigureInk& ink, const PanelSpace& space, const Region& r) {
  const QRectF frame(space.at(r.x_mm, r.y_mm + r.side_mm), space.at(r.x_mm + r.side_mm, r.y_mm));
  ink.painter().setBrush(Qt::NoBrush);
  ink.painter().setPen(ink.pen(kWindowRim, 2.2));
  ink.painter().drawRect(frame);
  ink.painter().setPen(ink.pen(kWindowPink, 1.2));
  ink.painter().drawRect(frame);
}

QString words(std::string_view text) {
  return QString::fromUtf8(text.data(), static_cast<int>(text.size()));
}

/// As typeset: with a minus instead of a hyphen.
QString numeral(const std::string& number) {
  return QString::fromStdString(number).replace('-', QChar(0x2212));
}

QString valueOf(const Quantity& q, const ShownLengths& lengths) {
  const ShownUnit unit = lengths.unitFor(q.unit);
  const double uncertainty = q.uncertainty / unit.size;
  const int decimals = decimalsFor(uncertainty);
  return QStringLiteral("%1 \u00b1 %2 %3")
      .arg(numeral(fixedDigits(q.value / unit.size, decimals)),
           QString::fromStdString(fixedDigits(uncertainty, decimals)), words(unit.name));
}

/// A place for a label beside `at`: above, below, below what is there already, or above it where
/// the panel ends.
QRectF labelPlace(const FigureInk& ink, const QRectF& panel, const QPointF& at, const QSizeF& size,
                  const std::vector<QRectF>& taken) {
  const double gap = ink.pt(3);
  const auto in_the_way = [&](const QRectF& box) {
    return std::find_if(taken.begin(), taken.end(),
                        [&](const QRectF& other) { return other.intersects(box); });
  };
  const QRectF above({at.x(), at.y() - gap - size.height()}, size);
  QRectF box = above;
  if (in_the_way(box) == taken.end()) return box;
  box.moveTop(at.y() + gap);
  for (auto other = in_the_way(box); other != taken.end(); other = in_the_way(box)) {
    box.moveTop(other->bottom() + 1);
  }
  if (box.bottom() <= panel.bottom()) return box;
  box = above;
  for (auto other = in_the_way(box); other != taken.end(); other = in_the_way(box)) {
    box.moveBottom(other->top() - 1);
  }
  return box;
}

/// Where a curve has its middle within a box; its first point if it never is.
QPointF shownPart(const QPolygonF& curve, const QRectF& box) {
  QPolygonF shown;
  std::copy_if(curve.begin(), curve.end(), std::back_inserter(shown),
               [&](const QPointF& p) { return box.contains(p); });
  return shown.empty() ? curve.front() : shown[shown.size() / 2];
}

struct Measured {
  const Measurement& m;
  const Reading& reading;
  const ShownLengths& lengths;
};

/// @param taken  the places of marks and labels, to which this one's is added
void measurement(FigureInk& ink, const PanelSpace& space, const Measured& measured,
                 std::vector<QRectF>& taken) {
  const auto& [m, reading, lengths] = measured;
  std::vector<QPolygonF> curves;
  for (const SectionCurve& curve : reading.curves) {
    curves.emplace_back();
    for (const ViewMm& p : curve.points) curves.back() << space.at(p.x, p.y);
    if (curve.closed) curves.back() << curves.back().front();
  }
  QPolygonF line;
  for (const PlaceMm& place : m.places) line << space.at(place.x, place.y);
  if (m.kind == MeasureKind::area) line << line.front();
  for (const auto& [colour, points] :
       {std::pair{QColor(255, 255, 255), 2.4}, std::pair{kInk, 1.0}}) {
    ink.painter().setPen(ink.pen(colour, points));
    ink.painter().setBrush(Qt::NoBrush);
    ink.painter().drawPolyline(line);
    for (const QPolygonF& curve : curves) ink.painter().drawPolyline(curve);
    ink.painter().setPen(Qt::NoPen);
    ink.painter().setBrush(colour);
    for (const QPointF& p : line) ink.painter().drawEllipse(p, ink.pt(points), ink.pt(points));
  }
  const QString label = QStringLiteral("%1: %2").arg(QString::fromStdString(m.name),
                                                     valueOf(reading.quantities.front(), lengths));
  const double width = ink.width(label, 0.9) + ink.pt(4);
  if (!curves.empty()) line << shownPart(curves.front(), space.box());
  QPointF at = 0.5 * (line.front() + line[std::min(1, line.size() - 1)]) + QPointF(ink.pt(4), 0);
  at.setX(std::clamp(at.x(), space.box().left(),
                     std::max(space.box().left(), space.box().right() - width)));
  const double height = ink.lineHeight(0.9);
  const QRectF box = labelPlace(ink, space.box(), at, {width, height}, taken);
  taken.push_back(box);
  plate(ink, box);
  ink.text({box.left() + ink.pt(2), box.bottom() - 0.28 * height}, label, Qt::AlignLeft, 0.9);
}

QRectF letterMark(FigureInk& ink, const PanelSpace& space, int letter, const QString& title) {
  const QString name = QString(QLatin1Char(static_cast<char>('a' + letter)));
  const double inset = ink.pt(kInsetPt);
  const double name_width = 1.1 * ink.width(name, 1.15);
  const double gap = title.isEmpty() ? 0 : inset;
  const QRectF box(space.box().left() + inset, space.box().top() + inset,
                   name_width + gap + ink.width(title) + 2 * inset, ink.lineHeight(1.15));
  plate(ink, box);
  const double baseline = box.bottom() - 0.28 * box.height();
  ink.text({box.left() + inset, baseline}, name, Qt::AlignLeft, 1.15, true);
  ink.text({box.left() + inset + name_width + gap, baseline}, title);
  return box;
}

/// Diagonal lines as the relief's hatch draws them: single, or crossed over darker ground.
void swatch(FigureInk& ink, const QRectF& box, bool crossed) {
  QPainter& painter = ink.painter();
  painter.save();
  painter.setClipRect(box);
  painter.fillRect(box, crossed ? kHatchedPlane : kHatchedStone);
  const double step = ink.pt(5);
  // A light line beside every dark one: both show on any ground.
  for (const auto& [colour, aside] :
       {std::pair{kHatchLight, ink.pt(1)}, std::pair{kHatchDark, 0.0}}) {
    painter.setPen(ink.pen(colour, 0.7));
    for (double x = box.left() - box.height() + aside; x < box.right(); x += step) {
      painter.drawLine(QPointF(x, box.top()), QPointF(x + box.height(), box.bottom()));
      if (crossed) painter.drawLine(QPointF(x, box.bottom()), QPointF(x + box.height(), box.top()));
    }
  }
  painter.restore();
  painter.setPen(ink.pen(kInk, 0.4));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(box);
}

}  // namespace

void drawMarks(FigureInk& ink, const Surface& surface, const Project& project,
               const DrawnSheet& sheet, int number) {
  const FigureRequest& f = project.figure;
  const FigurePanel& panel = sheet.layout.panels[static_cast<std::size_t>(number)];
  const PanelSpace space(ink, panel);
  ink.painter().save();
  ink.painter().setClipRect(space.box());
  if (panel.whole && f.window_outline) outline(ink, space, project.region);
  std::vector<QRectF> taken;
  if (f.scale_bar) taken.push_back(scaleBar(ink, space));
  if (f.height_bar && !panel.whole) {
    const HeightRange z = heightRange(cutOut(surface, panel.level, panel.shown, 0, project.gain));
    taken.push_back(heightBar(ink, space, z.max_mm - z.min_mm));
  }
  if (f.up_mark) taken.push_back(upMark(ink, space, upName(surface)));
  if (f.letters && sheet.layout.panels.size() > 1) {
    taken.push_back(letterMark(ink, space, number, panel.title));
  }
  // Over the marks and their words aside: a mark must not hide where a measurement ends.
  if (!panel.whole) {
    const ShownLengths lengths(surface);
    for (std::size_t i = 0; i < sheet.measured.size(); ++i) {
      measurement(ink, space, {project.measurements[i], sheet.measured[i], lengths}, taken);
    }
  }
  ink.painter().restore();
}

namespace {

struct Swatch {
  bool crossed = false;
  QString label;
};

std::vector<Swatch> swatchesOf(const Surface& surface, const Project& project) {
  std::vector<Swatch> swatches;
  if (!project.figure.hatch) return swatches;
  const auto [shares, of_object] = legendShares(surface, project);
  const QLatin1String whole(of_object ? "object" : "region");
  for (const auto& [origin, label, crossed] :
       {std::tuple{Origin::interpolated, "interpolated", false},
        std::tuple{Origin::base_plane, "hole, on the base plane", true}}) {
    const double share = shares[static_cast<std::size_t>(origin)];
    if (share == 0) continue;
    swatches.push_back(
        {crossed,
         QStringLiteral("%1, %2 % of the %3").arg(QLatin1String(label), text(100 * share), whole)});
  }
  return swatches;
}

QString titleOf(const ReliefValues& values, const ShownUnit& unit) {
  if (unit.name.empty()) return words(values.title);
  return QStringLiteral("%1 (%2)").arg(words(values.title), words(unit.name));
}

constexpr int kMostTickSteps = 5;
constexpr double kBarEm =
    13;  // Width of a bar, times the text's size; more if its numbers need it.

/// The bar that explains the colours: round numbers under it, as many decimals as their step needs.
class ColourBar {
 public:
  ColourBar(const FigureInk& ink, const ReliefValues& values, const ShownUnit& unit)
      : title_(titleOf(values, unit)) {
    const double low = values.low / unit.size;
    const double range = values.high / unit.size - low;
    const double step = axisFor(low, low + range, kMostTickSteps, AxisEnds::exact).step;
    double widest = 0;
    for (double n = std::ceil(low / step - kRounding); n * step <= low + range + kRounding * step;
         ++n) {
      ticks_.push_back({(n * step - low) / range, numeral(tickText(n * step, step))});
      widest = std::max(widest, ink.width(ticks_.back().label));
    }
    const double em = ink.pt(ink.textPt());
    bar_ = std::max(kBarEm * em, (widest + 0.8 * em) * range / step);
    for (const Tick& tick : ticks_) {
      const double half = 0.5 * ink.width(tick.label);
      left_ = std::max(left_, half - tick.at * bar_);
      right_ = std::max(right_, half - (1 - tick.at) * bar_);
    }
  }

  /// With what the outermost numbers stand out, at the text's size.
  double width() const { return left_ + bar_ + right_; }

  /// @param size  times the figure's text size
  void draw(FigureInk& ink, const QPointF& corner, ColourMap colours, double size) const {
    const double line = ink.lineHeight(size);
    const QRectF bar(corner.x() + size * left_, corner.y() + 0.1 * line, size * bar_, 0.7 * line);
    paint(ink, bar, colours);
    const double below = bar.bottom() + 0.95 * line;
    ink.painter().setPen(ink.pen(kInk, 0.4));
    for (const Tick& tick : ticks_) {
      const double x = bar.left() + tick.at * bar.width();
      ink.painter().drawLine(QPointF(x, bar.bottom()), QPointF(x, bar.bottom() + 0.15 * line));
      ink.text({x, below}, tick.label, Qt::AlignHCenter, size);
    }
    ink.text({bar.center().x(), below + 0.95 * line}, title_, Qt::AlignHCenter, size);
  }

 private:
  static constexpr double kRounding = 1e-9;  // Of a step.

  static void paint(FigureInk& ink, const QRectF& bar, ColourMap colours) {
    QPainter& painter = ink.painter();
    const int steps = 128;
    for (int i = 0; i < steps; ++i) {
      const Rgb8 c = colourOf(colours, (i + 0.5) / steps);
      const double from = bar.left() + bar.width() * i / steps;
      const double to = bar.left() + bar.width() * (i + 1) / steps;
      // Up to the end from each step on: no paper shines through between two of them.
      painter.fillRect(
          QRectF(from, bar.top(), i + 1 < steps ? bar.right() - from : to - from, bar.height()),
          QColor(c[0], c[1], c[2]));
    }
    painter.setBrush(Qt::NoBrush);
    painter.setPen(ink.pen(kInk, 0.4));
    painter.drawRect(bar);
  }

  struct Tick {
    double at = 0;  ///< Along the bar, 0 to 1.
    QString label;
  };
  QString title_;
  std::vector<Tick> ticks_;
  double bar_ = 0, left_ = 0, right_ = 0;  ///< Pixels.
};

}  // namespace

// One row. Where the figure is too narrow for it, its text is smaller.
void drawLegend(FigureInk& ink, const Surface& surface, const Project& project, const QRectF& paper,
                const ReliefValues& values) {
  const FigureRequest& f = project.figure;
  const QRectF box = ink.px(paper);
  std::optional<ColourBar> bar;
  if (hasLegend(f.look.kind)) {
    bar.emplace(ink, values, ShownLengths(surface).unitFor(values.unit));
  }
  const std::vector<Swatch> swatches = swatchesOf(surface, project);
  const double gap = ink.pt(10);
  double needed = bar ? bar->width() : 0;
  for (const Swatch& s : swatches) {
    needed += 1.6 * ink.lineHeight() + ink.pt(3) + gap + ink.width(s.label);
  }
  const double size = std::min(1.0, box.width() / std::max(needed, 1.0));
  const double line = ink.lineHeight(size);
  double x = box.left();
  if (bar) {
    bar->draw(ink, box.topLeft(), coloursOf(f.look), size);
    x += size * (bar->width() + gap);
  }
  for (const Swatch& s : swatches) {
    const QRectF field(x, box.top() + 0.1 * line, 1.6 * line, 0.8 * line);
    swatch(ink, field, s.crossed);
    ink.text({field.right() + size * ink.pt(3), field.bottom() - 0.12 * line}, s.label,
             Qt::AlignLeft, size);
    x = field.right() + size * (ink.pt(3) + gap + ink.width(s.label));
  }
}

}  // namespace relievo
