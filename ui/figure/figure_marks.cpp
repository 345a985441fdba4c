// SPDX-License-Identifier: BSD-3-Clause
#include "ui/figure/figure_marks.h"

#include <algorithm>
#include <QPainterPath>

#include "ui/figure/label_place.h"
#include "ui/vtk/window_pink.h"

namespace relievo {
namespace {

const QColor kWindowRim(40, 12, 26);

void outline(FigureInk& ink, const PanelSpace& space, const Region& r) {
  const QRectF frame(space.at(r.x_mm, r.y_mm + r.side_mm), space.at(r.x_mm + r.side_mm, r.y_mm));
  ink.painter().setBrush(Qt::NoBrush);
  ink.painter().setPen(ink.pen(kWindowRim, 2.2));
  ink.painter().drawRect(frame);
  ink.painter().setPen(ink.pen(QColor(kPink[0], kPink[1], kPink[2]), 1.2));
  ink.painter().drawRect(frame);
}

/// The up mark's arrow: its tip at the top of the plate.
void arrow(FigureInk& ink, const QRectF& box, double inset) {
  const double length = ink.pt(1.6 * ink.textPt());
  const QPointF tip(box.center().x(), box.top() + 0.6 * inset);
  QPainterPath head;
  head.moveTo(tip);
  head.lineTo(tip + QPointF(-0.28 * length, 0.6 * length));
  head.lineTo(tip + QPointF(0, 0.45 * length));
  head.lineTo(tip + QPointF(0.28 * length, 0.6 * length));
  head.closeSubpath();
  ink.painter().fillPath(head, kInk);
  ink.painter().setPen(ink.pen(kInk, 0.8));
  ink.painter().drawLine(tip + QPointF(0, 0.4 * length), tip + QPointF(0, length));
}

void drawMark(FigureInk& ink, const PlacedMark& mark, double inset) {
  ink.painter().fillRect(mark.box, kPlate);
  if (!mark.bar.isEmpty()) ink.painter().fillRect(mark.bar, kInk);
  if (mark.kind == PlacedMark::Kind::up) arrow(ink, mark.box, inset);
  for (const MarkWords& w : mark.words) {
    ink.text(w.at, w.text, w.centred ? Qt::AlignHCenter : Qt::AlignLeft, w.size, w.bold);
  }
}

void drawLines(FigureInk& ink, const MeasuredLines& lines) {
  QPainter& painter = ink.painter();
  for (const auto& [colour, points] :
       {std::pair{QColor(255, 255, 255), 2.4}, std::pair{kInk, 1.0}}) {
    painter.setPen(ink.pen(colour, points));
    painter.setBrush(Qt::NoBrush);
    painter.drawPolyline(lines.places);
    for (const QPolygonF& curve : lines.curves) painter.drawPolyline(curve);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    for (const QPointF& p : lines.places) painter.drawEllipse(p, ink.pt(points), ink.pt(points));
  }
}

}  // namespace

void drawMarks(FigureInk& ink, const Surface& surface, const Project& project,
               const DrawnSheet& sheet, int number) {
  const FigurePanel& panel = sheet.layout.panels[static_cast<std::size_t>(number)];
  const PanelMarks& placed = sheet.marks[static_cast<std::size_t>(number)];
  const PanelSpace space(ink, panel);
  ink.painter().save();
  ink.painter().setClipRect(space.box());
  if (panel.whole && project.figure.window_outline) outline(ink, space, project.region);
  const auto is_label = [](const PlacedMark& mark) {
    return mark.kind == PlacedMark::Kind::measurement;
  };
  for (const PlacedMark& mark : placed.marks) {
    if (!is_label(mark)) drawMark(ink, mark, space.inset());
  }
  // Over the marks: they must not hide where a measurement ends.
  if (!panel.whole) {
    const ShownLengths lengths(surface);
    for (std::size_t i = 0; i < sheet.measured.size(); ++i) {
      drawLines(ink, linesOf(space, {project.measurements[i], sheet.measured[i], lengths}));
    }
  }
  for (const PlacedMark& mark : placed.marks) {
    if (is_label(mark)) drawMark(ink, mark, space.inset());
  }
  ink.painter().restore();
}

}  // namespace relievo
