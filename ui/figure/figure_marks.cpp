// SPDX-License-Identifier: BSD-3-Clause
#include "ui/figure/figure_marks.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <QPainterPath>
#include <tuple>
#include <vector>

#include "core/measure/measure_text.h"
#include "core/project/caption.h"
#include "core/session/map_facts.h"
#include "ui/vtk/scale_length.h"

namespace relievo {
namespace {

const QColor kWindowPink(0xff, 0x4f, 0xa3);
const QColor kWindowRim(40, 12, 26);
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

QString valueOf(const Quantity& q) {
  const int decimals = decimalsFor(q.uncertainty);
  QString value = QString::number(q.value, 'f', decimals);
  value.replace('-', QChar(0x2212));
  return QStringLiteral("%1 \u00b1 %2 %3")
      .arg(value, QString::number(q.uncertainty, 'f', decimals),
           QString::fromUtf8(q.unit.data(), static_cast<int>(q.unit.size())));
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

/// @param taken  the places of marks and labels, to which this one's is added
void measurement(FigureInk& ink, const PanelSpace& space, const MapCells& map, const Measurement& m,
                 std::vector<QRectF>& taken) {
  const Reading reading = read(map, m);
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
                                                     valueOf(reading.quantities.front()));
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
  painter.fillRect(box, crossed ? QColor(176, 178, 182) : QColor(206, 205, 202));
  painter.setPen(ink.pen(QColor(96, 104, 122), 0.8));
  const double step = ink.pt(3.5);
  for (double x = box.left() - box.height(); x < box.right(); x += step) {
    painter.drawLine(QPointF(x, box.top()), QPointF(x + box.height(), box.bottom()));
    if (crossed) painter.drawLine(QPointF(x, box.bottom()), QPointF(x + box.height(), box.top()));
  }
  painter.restore();
  painter.setPen(ink.pen(kInk, 0.4));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(box);
}

}  // namespace

void drawMarks(FigureInk& ink, const Surface& surface, const Project& project,
               const FigureSheet& sheet, const FigurePanel& panel, int letter) {
  const FigureRequest& f = project.figure;
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
  if (f.letters && sheet.panels.size() > 1) {
    taken.push_back(letterMark(ink, space, letter, panel.title));
  }
  // Over the marks and their words aside: a mark must not hide where a measurement ends.
  if (f.measurements && !panel.whole) {
    const MapCells cells = mapCells(surface);
    for (const Measurement& m : project.measurements) measurement(ink, space, cells, m, taken);
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
  for (const auto& [origin, words, crossed] :
       {std::tuple{Origin::interpolated, "interpolated", false},
        std::tuple{Origin::base_plane, "hole, on the base plane", true}}) {
    const double share = shares[static_cast<std::size_t>(origin)];
    if (share == 0) continue;
    swatches.push_back(
        {crossed,
         QStringLiteral("%1, %2 % of the %3").arg(QLatin1String(words), text(100 * share), whole)});
  }
  return swatches;
}

QString titleOf(const ReliefValues& values) {
  const auto word = [](std::string_view t) {
    return QString::fromUtf8(t.data(), static_cast<int>(t.size()));
  };
  if (values.unit.empty()) return word(values.title);
  return QStringLiteral("%1 (%2)").arg(word(values.title), word(values.unit));
}

}  // namespace

// One row. Where the figure is too narrow for it, its text is smaller.
void drawLegend(FigureInk& ink, const Surface& surface, const Project& project, const QRectF& paper,
                const ReliefValues& values) {
  const FigureRequest& f = project.figure;
  const QRectF box = ink.px(paper);
  const bool coloured = hasLegend(f.look.kind);
  const std::vector<Swatch> swatches = swatchesOf(surface, project);
  const QString low = text(values.low);
  const QString high = text(values.high);
  const double gap = ink.pt(10);
  const double bar_width =
      coloured ? ink.width(low) + ink.width(titleOf(values)) + ink.width(high) + 2 * gap : 0;
  double needed = bar_width;
  for (const Swatch& s : swatches) {
    needed += 1.6 * ink.lineHeight() + ink.pt(3) + gap + ink.width(s.label);
  }
  const double size = std::min(1.0, box.width() / std::max(needed, 1.0));
  const double line = ink.lineHeight(size);
  double x = box.left();
  QPainter& painter = ink.painter();
  if (coloured) {
    const QRectF bar(x, box.top() + 0.1 * line, size * bar_width, 0.7 * line);
    const int steps = 128;
    for (int i = 0; i < steps; ++i) {
      const Rgb8 c = colourOf(coloursOf(f.look), (i + 0.5) / steps);
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
    const double below = bar.bottom() + 0.85 * line;
    ink.text({bar.left(), below}, low, Qt::AlignLeft, size);
    ink.text({bar.right(), below}, high, Qt::AlignRight, size);
    ink.text({bar.center().x(), below}, titleOf(values), Qt::AlignHCenter, size);
    x = bar.right() + size * gap;
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
