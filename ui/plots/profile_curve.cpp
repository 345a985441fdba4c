// SPDX-License-Identifier: BSD-3-Clause
#include "ui/plots/profile_curve.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <QBuffer>
#include <QCoreApplication>
#include <QFontMetricsF>
#include <QPainter>
#include <QSvgGenerator>

#include "ui/style/text.h"

namespace relievo {
namespace {

constexpr double kGap = 6;  // Between numbers and what they stand at, pixels.

QString said(const char* text) {
  return QCoreApplication::translate("relievo::ProfileStrip", text);
}

struct Span {
  double low = 0, high = 1;
  double length() const { return high - low; }
};

/// A round distance between numbers, with about so many of them.
double roundStep(double length, double wanted) {
  const double raw = length / std::max(wanted, 1.0);
  const double power = std::pow(10.0, std::floor(std::log10(raw)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= raw) return factor * power;
  }
  return 10 * power;
}

Span alongOf(const ProfileShown& shown) {
  const double first = shown.rows.front().along_mm, last = shown.rows.back().along_mm;
  return {first, last > first ? last : first + 1};
}

Span heightsOf(const ProfileShown& shown) {
  Span z{shown.rows.front().point.at.z, shown.rows.front().point.at.z};
  for (const ProfileRow& row : shown.rows) {
    z.low = std::min(z.low, row.point.at.z);
    z.high = std::max(z.high, row.point.at.z);
  }
  // A level line is drawn in the middle, and a rounding does not look like a step.
  constexpr double kLeastMm = 0.01;
  const double room = std::max(0.08 * z.length(), 0.5 * (kLeastMm - z.length()));
  return {z.low - room, z.high + room};
}

/// Where numbers, curve and names lie in a drawing.
struct Frame {
  Span along, heights;
  QRectF area;

  Frame(const QRectF& box, const QFont& font, const ProfileShown& shown)
      : along(alongOf(shown)), heights(heightsOf(shown)) {
    const QFontMetricsF metrics(font);
    const double left = std::max(metrics.horizontalAdvance(numberText(heights.low, 2)),
                                 metrics.horizontalAdvance(numberText(heights.high, 2))) +
                        2 * kGap;
    area = box.adjusted(left, 0.6 * metrics.height(), -2 * kGap, -(metrics.height() + kGap));
  }
  double x(double along_mm) const {
    return area.left() + area.width() * (along_mm - along.low) / along.length();
  }
  double y(double height_mm) const {
    return area.bottom() - area.height() * (height_mm - heights.low) / heights.length();
  }
};

int decimalsOf(double step) {
  return std::clamp(static_cast<int>(-std::floor(std::log10(step) + 1e-9)), 0, 4);
}

void drawNumbers(QPainter& painter, const Frame& frame, const ProfileColours& colours) {
  const QFontMetricsF metrics(painter.font());
  const double line = metrics.height();
  const double up = roundStep(frame.heights.length(), frame.area.height() / (2.2 * line));
  for (double z = std::ceil(frame.heights.low / up) * up; z <= frame.heights.high; z += up) {
    painter.setPen(QPen(colours.grid, 0.5));
    painter.drawLine(QPointF(frame.area.left(), frame.y(z)),
                     QPointF(frame.area.right(), frame.y(z)));
    painter.setPen(colours.text);
    painter.drawText(QRectF(0, frame.y(z) - line, frame.area.left() - kGap, 2 * line),
                     Qt::AlignRight | Qt::AlignVCenter,
                     numberText(std::abs(z) < 1e-9 * up ? 0 : z, decimalsOf(up)));
  }
  const double wide = metrics.horizontalAdvance(numberText(frame.along.high, 2));
  const double on = roundStep(frame.along.length(), frame.area.width() / (2.5 * wide));
  const QString unit = QStringLiteral(" mm");
  for (double s = std::ceil(frame.along.low / on) * on; s <= frame.along.high + 1e-9; s += on) {
    painter.setPen(QPen(colours.grid, 0.5));
    painter.drawLine(QPointF(frame.x(s), frame.area.top()),
                     QPointF(frame.x(s), frame.area.bottom()));
    painter.setPen(colours.text);
    const bool last = s + on > frame.along.high + 1e-9;
    const QString number = numberText(s, decimalsOf(on)) + (last ? unit : QString());
    const double half = 0.5 * metrics.horizontalAdvance(number);
    const double middle = std::min(frame.x(s), frame.area.right() + kGap - half);
    painter.drawText(QPointF(middle - half, frame.area.bottom() + kGap + metrics.ascent()), number);
  }
}

}  // namespace

QString profileText(const ProfileShown& shown) {
  const auto range = [&](std::size_t from, std::size_t to) {
    const auto [low, high] = std::minmax_element(
        shown.rows.begin() + static_cast<std::ptrdiff_t>(from),
        shown.rows.begin() + static_cast<std::ptrdiff_t>(to) + 1,
        [](const ProfileRow& a, const ProfileRow& b) { return a.point.at.z < b.point.at.z; });
    return high->point.at.z - low->point.at.z;
  };
  const std::size_t last = shown.rows.size() - 1;
  if (!shown.cursor) {
    return said(QT_TRANSLATE_NOOP("relievo::ProfileStrip", "%1 mm long, %2 mm deep"))
        .arg(numberText(shown.rows[last].along_mm - shown.rows.front().along_mm, 2),
             numberText(range(0, last), 2));
  }
  const ProfileRow& at = shown.rows[*shown.cursor];
  if (!shown.mark || *shown.mark == *shown.cursor) {
    return said(QT_TRANSLATE_NOOP("relievo::ProfileStrip", "at %1 mm: height %2 mm"))
        .arg(numberText(at.along_mm, 2), numberText(at.point.at.z, 2));
  }
  const ProfileRow& from = shown.rows[*shown.mark];
  const auto [low, high] = std::minmax(*shown.mark, *shown.cursor);
  return said(QT_TRANSLATE_NOOP("relievo::ProfileStrip",
                                "%1 to %2 mm: %3 mm long, %4 mm deep, ends differ by %5 mm"))
      .arg(numberText(from.along_mm, 2), numberText(at.along_mm, 2),
           numberText(std::abs(at.along_mm - from.along_mm), 2), numberText(range(low, high), 2),
           numberText(at.point.at.z - from.point.at.z, 2));
}

void drawProfile(QPainter& painter, const QRectF& box, const QFont& font, const ProfileShown& shown,
                 const ProfileColours& colours) {
  const Frame frame(box, font, shown);
  painter.setFont(font);
  painter.fillRect(box, colours.background);
  if (frame.area.width() < 20 || frame.area.height() < 10) return;
  drawNumbers(painter, frame, colours);
  if (shown.cursor && shown.mark) {
    const double a = frame.x(shown.rows[*shown.mark].along_mm);
    const double b = frame.x(shown.rows[*shown.cursor].along_mm);
    painter.fillRect(QRectF(QPointF(std::min(a, b), frame.area.top()),
                            QPointF(std::max(a, b), frame.area.bottom())),
                     colours.piece);
  }
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(colours.curve, 1.8));
  QPolygonF piece;
  for (const ProfileRow& row : shown.rows) {
    if (!row.joined && !piece.isEmpty()) {
      painter.drawPolyline(piece);
      piece.clear();
    }
    piece << QPointF(frame.x(row.along_mm), frame.y(row.point.at.z));
  }
  painter.drawPolyline(piece);
  if (!shown.cursor) return;
  const ProfileRow& at = shown.rows[*shown.cursor];
  const QPointF place(frame.x(at.along_mm), frame.y(at.point.at.z));
  painter.setPen(QPen(colours.cursor, 1.5));
  painter.drawLine(QPointF(place.x(), frame.area.top()), QPointF(place.x(), frame.area.bottom()));
  painter.setBrush(colours.cursor);
  painter.drawEllipse(place, 3.5, 3.5);
}

std::size_t profileRowAt(const QRectF& box, const QFont& font, const ProfileShown& shown,
                         const QPointF& point) {
  const Frame frame(box, font, shown);
  const double share = (point.x() - frame.area.left()) / std::max(frame.area.width(), 1.0);
  const double along = frame.along.low + share * frame.along.length();
  const auto after =
      std::lower_bound(shown.rows.begin(), shown.rows.end(), along,
                       [](const ProfileRow& row, double wanted) { return row.along_mm < wanted; });
  if (after == shown.rows.begin()) return 0;
  if (after == shown.rows.end()) return shown.rows.size() - 1;
  const bool before = along - std::prev(after)->along_mm < after->along_mm - along;
  return static_cast<std::size_t>(after - shown.rows.begin()) - (before ? 1 : 0);
}

std::string profileDrawing(const ProfileShown& shown, const QFont& font, const QSizeF& pixels) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  QSvgGenerator generator;
  generator.setOutputDevice(&buffer);
  constexpr int kDpi = 96;
  generator.setResolution(kDpi);
  generator.setSize(pixels.toSize());
  generator.setViewBox(QRectF(QPointF(0, 0), pixels));
  generator.setTitle(profileText(shown));
  QPainter painter(&generator);
  const double line = QFontMetricsF(font).height();
  const ProfileColours paper{Qt::white,          QColor(205, 205, 205), Qt::black,
                             QColor(0, 70, 150), QColor(190, 30, 30),   QColor(190, 30, 30, 40)};
  drawProfile(painter, QRectF(QPointF(0, line), pixels - QSizeF(0, line)), font, shown, paper);
  painter.setPen(Qt::black);
  painter.drawText(QPointF(kGap, QFontMetricsF(font).ascent()), profileText(shown));
  painter.end();
  return bytes.toStdString();
}

}  // namespace relievo
