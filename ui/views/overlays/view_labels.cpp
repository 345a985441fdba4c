// SPDX-License-Identifier: BSD-3-Clause
#include "ui/views/overlays/view_labels.h"

#include <algorithm>
#include <QPainter>
#include <utility>

namespace relievo {
namespace {

constexpr int kPadding = 4;
constexpr double kAway = 8;  // From its place, pixels.
constexpr int kMostTries = 8;
constexpr double kMostOfView = 0.45;  // Of its width: in a small view they would hide the relief.

}  // namespace

ViewLabels::ViewLabels(QWidget* view, std::function<QPointF(const ViewMm&)> point_over)
    : QWidget(view), point_over_(std::move(point_over)) {
  setObjectName(QStringLiteral("view_labels"));
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setAttribute(Qt::WA_NoSystemBackground);
  hide();
}

void ViewLabels::setLabels(const std::vector<ViewLabel>& labels) {
  if (labels == labels_) return;
  labels_ = labels;
  place();
}

void ViewLabels::setMark(const std::optional<ViewMm>& mark) {
  if (mark == mark_) return;
  mark_ = mark;
  place();
}

void ViewLabels::setOff(bool off) {
  if (off == off_) return;
  off_ = off;
  place();
}

void ViewLabels::place() {
  setGeometry(parentWidget()->rect());
  setVisible(!off_ && (!labels_.empty() || mark_.has_value()));
  update();
}

void ViewLabels::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QFontMetrics metrics = fontMetrics();
  const QRect inside = rect().adjusted(kPadding, kPadding, -kPadding, -kPadding);
  std::vector<QRect> taken;
  for (const ViewLabel& label : labels_) {
    const QPointF at = point_over_(label.at);
    if (!QRectF(rect()).contains(at)) continue;
    QRect box(QPoint(0, 0), QSize(metrics.horizontalAdvance(label.text) + 2 * kPadding,
                                  metrics.height() + kPadding));
    if (box.width() > kMostOfView * width()) continue;
    box.moveBottomLeft((at + QPointF(kAway, -kAway)).toPoint());
    if (box.right() > inside.right()) box.moveRight(inside.right());
    if (box.top() < inside.top()) box.moveTop((at + QPointF(0, kAway)).toPoint().y());
    // Below those that are there already.
    for (int i = 0; i < kMostTries; ++i) {
      const auto other = std::find_if(taken.begin(), taken.end(),
                                      [&](const QRect& t) { return t.intersects(box); });
      if (other == taken.end()) break;
      box.moveTop(other->bottom() + 1);
    }
    taken.push_back(box);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(18, 18, 20, 190));
    painter.drawRoundedRect(box, 3, 3);
    painter.setPen(QColor(245, 245, 245));
    painter.drawText(box, Qt::AlignCenter, label.text);
  }
  drawMark(painter);
}

/// A ring with a dot: seen on bright and dark surfaces, and no proxy, which is a ball.
void ViewLabels::drawMark(QPainter& painter) const {
  if (!mark_) return;
  const QPointF at = point_over_(*mark_);
  const double size = 0.4 * fontMetrics().height();
  painter.setBrush(Qt::NoBrush);
  for (const auto& [width, colour] :
       {std::pair{4.5, QColor(18, 18, 20)}, std::pair{2.0, QColor(255, 209, 64)}}) {
    painter.setPen(QPen(colour, width));
    painter.drawEllipse(at, size, size);
    painter.drawPoint(at);
  }
}

}  // namespace relievo
