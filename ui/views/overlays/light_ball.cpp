// SPDX-License-Identifier: BSD-3-Clause
#include "ui/views/overlays/light_ball.h"

#include <algorithm>
#include <cmath>
#include <QEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QRadialGradient>

#include "ui/views/overlays/corner.h"

namespace relievo {
namespace {

constexpr double kDeg = 3.14159265358979323846 / 180;
constexpr double kLines = 3.4;   // Its size, in lines of text.
constexpr int kViewsAround = 3;  // Smaller views than so many of it have none.

}  // namespace

LightOptions turnedLight(LightOptions light, double clockwise_deg, double higher_deg) {
  const double azimuth = std::fmod(light.azimuth_deg + clockwise_deg, 360.0);
  light.azimuth_deg = azimuth < 0 ? azimuth + 360 : azimuth;
  light.elevation_deg = std::clamp(light.elevation_deg + higher_deg, kLeastLightDeg, 90.0);
  return light;
}

LightBall::LightBall(QWidget* view) : QWidget(view) {
  setObjectName(QStringLiteral("light_ball"));
  setAccessibleName(tr("Light"));
  setToolTip(
      tr("Drag to move the light: the rim is raking light, the middle is light from you. Arrows "
         "move it by 5 degrees"));
  setFocusPolicy(Qt::TabFocus);
  setCursor(Qt::PointingHandCursor);
  show(LightOptions{});
}

void LightBall::show(const LightOptions& light) {
  light_ = light;
  setAccessibleDescription(tr("Light from %1\u00b0, %2\u00b0 high")
                               .arg(std::lround(light.azimuth_deg))
                               .arg(std::lround(light.elevation_deg)));
  update();
}

void LightBall::setUsable(bool usable) {
  usable_ = usable;
  place();
}

void LightBall::place() {
  const int side = static_cast<int>(kLines * fontMetrics().height());
  const QWidget* view = parentWidget();
  // The upper left corner is that of the object's small picture, while there is one.
  const auto* inset = view->findChild<QWidget*>(QStringLiteral("overview_inset"));
  const int top = inset != nullptr && inset->isVisible() ? inset->geometry().bottom() : 0;
  setGeometry(kCornerMargin, top + kCornerMargin, side, side);
  setVisible(usable_ && std::min(view->width(), view->height()) >= kViewsAround * side);
}

double LightBall::radius() const {
  return 0.5 * std::min(width(), height()) - 3;
}

QPointF LightBall::spotOf(const LightOptions& light) const {
  const double reach = radius() * std::cos(light.elevation_deg * kDeg);
  const double azimuth = light.azimuth_deg * kDeg;
  return QRectF(rect()).center() + QPointF(reach * std::sin(azimuth), -reach * std::cos(azimuth));
}

LightOptions LightBall::lightAt(const QPointF& point) const {
  const QPointF from = point - QRectF(rect()).center();
  const double reach = std::hypot(from.x(), from.y()) / std::max(radius(), 1.0);
  LightOptions light = light_;
  // From straight above every direction is the same: the one before stays.
  constexpr double kMiddle = 0.02;
  if (reach > kMiddle) {
    light.azimuth_deg = std::atan2(from.x(), -from.y()) / kDeg;
    if (light.azimuth_deg < 0) light.azimuth_deg += 360;
  }
  light.elevation_deg = std::max(std::acos(std::min(reach, 1.0)) / kDeg, kLeastLightDeg);
  return light;
}

void LightBall::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QPointF middle = QRectF(rect()).center();
  const QPointF spot = spotOf(light_);
  QRadialGradient stone(middle, radius(), middle + 0.95 * (spot - middle));
  stone.setColorAt(0, QColor(250, 248, 240));
  stone.setColorAt(0.35, QColor(190, 187, 180));
  stone.setColorAt(1, QColor(42, 42, 46));
  painter.setBrush(stone);
  painter.setPen(QPen(hasFocus() ? palette().color(QPalette::Highlight) : QColor(16, 16, 18),
                      hasFocus() ? 3 : 1.5));
  painter.drawEllipse(middle, radius(), radius());
  // The sun itself: seen on a bright and on a dark sphere.
  painter.setPen(QPen(QColor(16, 16, 18), 1.5));
  painter.setBrush(QColor(255, 209, 64));
  const double dot = std::max(3.5, 0.12 * radius());
  painter.drawEllipse(spot, dot, dot);
}

void LightBall::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;  // Taken: it is not the view that is pressed.
  dragging_ = true;
  Q_EMIT dragged(lightAt(event->localPos()), ++drags_);
}

void LightBall::mouseMoveEvent(QMouseEvent* event) {
  if ((event->buttons() & Qt::LeftButton) == 0) dragging_ = false;  // The release went astray.
  if (dragging_) Q_EMIT dragged(lightAt(event->localPos()), drags_);
}

void LightBall::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) dragging_ = false;
}

void LightBall::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
    case Qt::Key_Left:
      return Q_EMIT stepped(-1, 0);
    case Qt::Key_Right:
      return Q_EMIT stepped(1, 0);
    case Qt::Key_Up:
      return Q_EMIT stepped(0, 1);
    case Qt::Key_Down:
      return Q_EMIT stepped(0, -1);
    default:
      QWidget::keyPressEvent(event);
  }
}

void LightBall::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange) place();
}

}  // namespace relievo
