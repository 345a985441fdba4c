// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/haptics/device/homing_picture.h"

#include <algorithm>
#include <optional>
#include <QPainter>
#include <QPainterPath>

namespace relievo {

using falcon::LinkState;

namespace {

// In parts of the picture's height; it is twice as wide.
constexpr double kBody = 0.62, kMiddle = 0.5, kBall = 0.11;
constexpr double kIn = 0.92, kOut = 1.62;  // Where the ball's middle is.

/// 1: push in, -1: pull out, 0: nothing is to be done.
int wayOf(LinkState state) {
  return state == LinkState::homing ? 1 : state == LinkState::pull_out ? -1 : 0;
}

/// As Link::lights says.
QColor lightOf(LinkState state) {
  if (state == LinkState::homing) return {214, 56, 48};
  if (state == LinkState::pull_out) return {60, 110, 230};
  return state == LinkState::ready ? QColor(60, 110, 230) : QColor(120, 120, 120);
}

QPainterPath arrow(double from, double to, double y, double size) {
  const double back = to > from ? -size : size;
  QPainterPath path;
  path.moveTo(from, y);
  path.lineTo(to, y);
  path.moveTo(to + back, y - size);
  path.lineTo(to, y);
  path.lineTo(to + back, y + size);
  return path;
}

}  // namespace

HomingPicture::HomingPicture(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("homingPicture"));
  setAccessibleName(tr("What to do with the grip"));
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Preferred);
  show(LinkState::absent);
}

QSize HomingPicture::sizeHint() const {
  const int height = 7 * fontMetrics().height();
  return {2 * height, height};
}

QSize HomingPicture::minimumSizeHint() const {
  return sizeHint() / 2;  // Large text on a small screen.
}

void HomingPicture::show(LinkState state) {
  state_ = state;
  const int way = wayOf(state);
  setAccessibleDescription(way > 0   ? tr("Push the grip all the way in. The light is red.")
                           : way < 0 ? tr("Pull the grip all the way out. The light is blue.")
                           : state == LinkState::ready
                               ? tr("The grip's place is known. The light is blue.")
                               : tr("Nothing to do with the grip yet."));
  setToolTip(accessibleDescription());
  update();
}

void HomingPicture::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const double unit = std::min(height(), width() / 2);
  const int way = wayOf(state_);
  const QColor ink = palette().color(QPalette::WindowText);
  const QColor paper = palette().color(QPalette::Base);
  painter.setPen(QPen(ink, 0.02 * unit));
  painter.setBrush(paper);
  const double ball = (way > 0 ? kIn : way < 0 ? kOut : 0.5 * (kIn + kOut)) * unit;
  const double middle = kMiddle * unit;
  // Three arms hold the ball; two are seen from the side.
  for (const double arm : {-0.3, 0.3}) {
    const QPointF shoulder(kBody * unit, middle + arm * unit);
    const QPointF elbow(0.5 * (shoulder.x() + ball), middle + 1.25 * arm * unit);
    painter.drawPolyline(QPolygonF({shoulder, elbow, QPointF(ball, middle)}));
  }
  painter.drawRoundedRect(QRectF(0.06 * unit, 0.1 * unit, (kBody - 0.06) * unit, 0.8 * unit),
                          0.2 * unit, 0.2 * unit);
  painter.setBrush(lightOf(state_));
  painter.drawEllipse(QPointF(0.34 * unit, middle), 0.12 * unit, 0.12 * unit);
  painter.setBrush(palette().color(QPalette::Mid));
  painter.drawEllipse(QPointF(ball, middle), kBall * unit, kBall * unit);
  if (way == 0) return;
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(palette().color(QPalette::Highlight), 0.05 * unit, Qt::SolidLine,
                      Qt::RoundCap, Qt::RoundJoin));
  const double start = (way > 0 ? kOut : kIn) * unit, end = (way > 0 ? kIn : kOut) * unit;
  painter.drawPath(arrow(start, end, 0.88 * unit, 0.08 * unit));
}

}  // namespace relievo
