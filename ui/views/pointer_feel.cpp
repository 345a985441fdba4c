// SPDX-License-Identifier: BSD-3-Clause
#include "ui/views/pointer_feel.h"

#include <algorithm>
#include <cmath>
#include <QCursor>
#include <QGuiApplication>
#include <QMouseEvent>
#include <QPainter>
#include <QPixmap>

#include "ui/views/detail_view.h"

namespace relievo {
namespace {

constexpr double kSlowest = 0.25, kFastest = 2;
constexpr int kSmallestPx = 10, kLargestPx = 46;  // Systems draw pointers of up to 64.
constexpr int kSizeStepPx = 2;

/// A ring that is seen on light and on dark, with its middle free.
QCursor ring(int diameter_px) {
  constexpr int kEdge = 3;
  constexpr double kWide = 4, kNarrow = 2;
  const int side = diameter_px + 2 * kEdge;
  QPixmap picture(side, side);
  picture.fill(Qt::transparent);
  QPainter painter(&picture);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF circle(kEdge, kEdge, diameter_px, diameter_px);
  painter.setPen(QPen(Qt::white, kWide));
  painter.drawEllipse(circle);
  painter.setPen(QPen(Qt::black, kNarrow));
  painter.drawEllipse(circle);
  painter.drawPoint(circle.center());
  return {picture, side / 2, side / 2};
}

}  // namespace

double feltGain(double rise_per_way) noexcept {
  if (!std::isfinite(rise_per_way)) return 1;
  return rise_per_way > 0 ? std::max(kSlowest, 1 / (1 + rise_per_way))
                          : std::min(kFastest, 1 - rise_per_way);
}

int feltDiameterPx(double height_share) noexcept {
  const double share = std::isfinite(height_share) ? std::clamp(height_share, 0.0, 1.0) : 0.5;
  const double px = kSmallestPx + share * (kLargestPx - kSmallestPx);
  return kSizeStepPx * static_cast<int>(std::lround(px / kSizeStepPx));
}

PointerFeel::PointerFeel(DetailView& view)
    : QObject(&view),
      view_(view),
      can_move_pointer_(QGuiApplication::platformName() == QLatin1String("xcb")) {
  view.installEventFilter(this);
}

void PointerFeel::setOn(bool on) {
  if (on == is_on_) return;
  is_on_ = on;
  mouse_.reset();
  asked_.clear();
  diameter_px_ = 0;
  if (on) {
    showSize(view_.mapFromGlobal(QCursor::pos()));
  } else {
    view_.setOwnCursor(std::nullopt);
  }
}

bool PointerFeel::eventFilter(QObject* watched, QEvent* event) {
  if (!is_on_) return false;
  if (event->type() == QEvent::Leave || event->type() == QEvent::MouseButtonPress) mouse_.reset();
  if (event->type() != QEvent::MouseMove) return QObject::eventFilter(watched, event);
  return moved(*static_cast<QMouseEvent*>(event));
}

/// Whether an event only says that the pointer is where it was put.
bool PointerFeel::isOfOurs(const QPoint& at) {
  const auto found = std::find(asked_.begin(), asked_.end(), at);
  if (found == asked_.end()) return false;
  asked_.erase(asked_.begin(), found + 1);
  return true;
}

/// @return whether the event is not the view's: the pointer goes elsewhere, which is told by
/// another
bool PointerFeel::moved(const QMouseEvent& event) {
  const QPoint at = event.pos();
  if (event.buttons() != Qt::NoButton || !mouse_) {
    mouse_ = event.buttons() == Qt::NoButton ? std::optional(at) : std::nullopt;
    pointer_ = at;
    asked_.clear();
    return false;
  }
  if (isOfOurs(at)) {
    mouse_ = at;
    showSize(at);
    return false;
  }
  const QPointF way = at - *mouse_;
  mouse_ = at;
  const double gain = can_move_pointer_ ? feltGain(view_.risePerWay(pointer_, pointer_ + way)) : 1;
  pointer_ += gain * way;
  const QPoint to = pointer_.toPoint();
  // Over the edge it goes as the mouse goes: nothing holds it in the view.
  if (to == at || !view_.rect().contains(to)) {
    pointer_ = to == at ? pointer_ : QPointF(at);
    showSize(at);
    return false;
  }
  asked_.push_back(to);
  QCursor::setPos(view_.mapToGlobal(to));
  return true;
}

void PointerFeel::showSize(const QPointF& at) {
  const int diameter_px = feltDiameterPx(view_.heightShare(at));
  if (diameter_px == diameter_px_) return;
  diameter_px_ = diameter_px;
  view_.setOwnCursor(ring(diameter_px));
}

}  // namespace relievo
