// SPDX-License-Identifier: BSD-3-Clause
#include "ui/figure/label_place.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/base/axis.h"
#include "core/measure/measure_text.h"

namespace relievo {
namespace {

constexpr double kLabelSize = 0.9;
constexpr int kLeastLetters = 2;  // Of a name that is shortened.

QString valueOf(const Quantity& q, const ShownLengths& lengths) {
  const ShownUnit unit = lengths.unitFor(q.unit);
  const double uncertainty = q.uncertainty / unit.size;
  const int decimals = decimalsFor(uncertainty);
  return QStringLiteral("%1 \u00b1 %2 %3")
      .arg(numeral(fixedDigits(q.value / unit.size, decimals)),
           QString::fromStdString(fixedDigits(uncertainty, decimals)), words(unit.name));
}

/// A name in at most `room` pixels; empty if that leaves nothing of it.
QString shortened(const FigureInk& ink, const QString& name, double room) {
  if (ink.width(name, kLabelSize) <= room) return name;
  for (int letters = name.size() - 1; letters >= kLeastLetters; --letters) {
    const QString part = name.left(letters).trimmed() + QChar(0x2026);
    if (ink.width(part, kLabelSize) <= room) return part;
  }
  return {};
}

struct Label {
  std::vector<QString> lines;
  double size = kLabelSize;
};

/// From the best on: never without the value.
std::vector<Label> formsOf(const FigureInk& ink, const QString& name, const QString& value,
                           double room) {
  std::vector<Label> forms;
  const QString mark = QStringLiteral(": ");
  if (ink.width(name + mark + value, kLabelSize) <= room) {
    forms.push_back({{name + mark + value}});
  }
  if (ink.width(value, kLabelSize) <= room) {
    const QString above = shortened(ink, name, room - ink.width(mark, kLabelSize));
    if (!above.isEmpty()) forms.push_back({{above + ':', value}});
    const QString before = shortened(ink, name, room - ink.width(mark + value, kLabelSize));
    if (!before.isEmpty() && before != name) forms.push_back({{before + mark + value}});
    forms.push_back({{value}});
  }
  if (std::vector<QString> lines = wrapped(ink, value, room, kLabelSize); lines.size() > 1) {
    forms.push_back({std::move(lines)});
  }
  forms.push_back({{value}, std::min(kLabelSize, room / ink.width(value))});
  return forms;
}

/// Above or below `at`, below what is there already, above it, or else the nearest free place.
std::optional<QRectF> placeOf(const QRectF& panel, const QPointF& at, const QSizeF& size,
                              double gap, const std::vector<QRectF>& taken) {
  const auto in_the_way = [&](const QRectF& box) {
    return std::find_if(taken.begin(), taken.end(),
                        [&](const QRectF& other) { return other.intersects(box); });
  };
  const QRectF above({at.x(), at.y() - gap - size.height()}, size);
  QRectF down = above, up = above;
  if (in_the_way(down) != taken.end() || down.top() < panel.top()) down.moveTop(at.y() + gap);
  for (auto o = in_the_way(down); o != taken.end(); o = in_the_way(down)) {
    down.moveTop(o->bottom() + 1);
  }
  for (auto o = in_the_way(up); o != taken.end(); o = in_the_way(up)) up.moveBottom(o->top() - 1);
  for (const QRectF& box : {above, down, up}) {
    if (isFree(box, panel, taken)) return box;
  }
  std::vector<double> xs{at.x(), panel.left(), panel.right() - size.width()};
  std::vector<double> ys{panel.top(), panel.bottom() - size.height()};
  for (const QRectF& o : taken) {
    xs.insert(xs.end(), {o.left() - size.width() - 1, o.right() + 1});
    ys.insert(ys.end(), {o.top() - size.height() - 1, o.bottom() + 1});
  }
  std::optional<QRectF> nearest;
  const auto distance = [&](const QRectF& box) {
    return std::hypot(box.left() - above.left(), box.top() - above.top());
  };
  for (const double x : xs) {
    for (const double y : ys) {
      const QRectF box({x, y}, size);
      if (!isFree(box, panel, taken)) continue;
      if (!nearest || distance(box) < distance(*nearest)) nearest = box;
    }
  }
  return nearest;
}

/// Where a curve has its middle within a box; its first point if it never is.
QPointF shownPart(const QPolygonF& curve, const QRectF& box) {
  QPolygonF shown;
  std::copy_if(curve.begin(), curve.end(), std::back_inserter(shown),
               [&](const QPointF& p) { return box.contains(p); });
  return shown.empty() ? curve.front() : shown[shown.size() / 2];
}

}  // namespace

QString words(std::string_view text) {
  return QString::fromUtf8(text.data(), static_cast<int>(text.size()));
}

QString numeral(const std::string& number) {
  return QString::fromStdString(number).replace('-', QChar(0x2212));
}

bool isFree(const QRectF& box, const QRectF& panel, const std::vector<QRectF>& taken) {
  constexpr double kRounding = 1e-6;
  if (!panel.adjusted(-kRounding, -kRounding, kRounding, kRounding).contains(box)) return false;
  return std::none_of(taken.begin(), taken.end(),
                      [&](const QRectF& other) { return other.intersects(box); });
}

MeasuredLines linesOf(const PanelSpace& space, const DrawnMeasurement& measured) {
  MeasuredLines lines;
  for (const SectionCurve& curve : measured.reading.curves) {
    lines.curves.emplace_back();
    for (const ViewMm& p : curve.points) lines.curves.back() << space.at(p.x, p.y);
    if (curve.closed) lines.curves.back() << lines.curves.back().front();
  }
  for (const PlaceMm& place : measured.m.places) lines.places << space.at(place.x, place.y);
  if (measured.m.kind == MeasureKind::area) lines.places << lines.places.front();
  return lines;
}

std::optional<PlacedMark> labelOf(const FigureInk& ink, const PanelSpace& space,
                                  const DrawnMeasurement& measured,
                                  const std::vector<QRectF>& taken) {
  const auto [places, curves] = linesOf(space, measured);
  QPolygonF line = places;
  if (!curves.empty()) line << shownPart(curves.front(), space.box());
  const QPointF beside =
      0.5 * (line.front() + line[std::min(1, line.size() - 1)]) + QPointF(ink.pt(4), 0);
  const QRectF& panel = space.box();
  const double rim = std::min(ink.pt(2), space.inset());
  const QString value = valueOf(measured.reading.quantities.front(), measured.lengths);
  for (const Label& form :
       formsOf(ink, QString::fromStdString(measured.m.name), value, panel.width() - 2 * rim)) {
    double width = 0;
    for (const QString& text : form.lines) width = std::max(width, ink.width(text, form.size));
    width += 2 * rim;
    const double height = ink.lineHeight(form.size);
    const double x =
        std::clamp(beside.x(), panel.left(), std::max(panel.left(), panel.right() - width));
    const auto box =
        placeOf(panel, {x, beside.y()}, {width, height * static_cast<double>(form.lines.size())},
                ink.pt(3), taken);
    if (!box) continue;
    PlacedMark label{.kind = PlacedMark::Kind::measurement, .box = *box, .words = {}};
    for (std::size_t i = 0; i < form.lines.size(); ++i) {
      const double baseline = box->top() + (static_cast<double>(i) + 0.72) * height;
      label.words.push_back({{box->left() + rim, baseline}, form.lines[i], false, form.size});
    }
    return label;
  }
  return std::nullopt;
}

}  // namespace relievo
