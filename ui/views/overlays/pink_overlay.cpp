// SPDX-License-Identifier: BSD-3-Clause
#include "ui/views/overlays/pink_overlay.h"

#include <algorithm>
#include <cmath>
#include <QPainter>

#include "ui/style/palette.h"
#include "ui/views/view_pixels.h"
#include "ui/vtk/window_pink.h"

namespace relievo {

PinkOverlay::PinkOverlay(QWidget* view) : QWidget(view) {
  setObjectName(QStringLiteral("pink_overlay"));
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setAttribute(Qt::WA_NoSystemBackground);
}

void PinkOverlay::setFrame(const std::optional<QRectF>& frame) {
  if (frame == frame_) return;
  frame_ = frame;
  update();
}

// As ScreenMarks::pinkWindow: pink between dark on either side, seen on any surface.
void PinkOverlay::paintEvent(QPaintEvent* /*event*/) {
  if (!frame_) return;
  const double half =
      std::max(1.0, std::round(std::max(1.0, logicalDpiX() / kPlainDpi) * textScale()));
  const QColor pink(kPink[0], kPink[1], kPink[2]), dark(40, 12, 26);
  const QPointF a(std::round(frame_->left()), std::round(frame_->top()));
  const QPointF b(std::round(frame_->right()), std::round(frame_->bottom()));
  QPainter painter(this);
  painter.setPen(Qt::NoPen);
  const auto frame = [&](double width, const QColor& colour) {
    const QPointF w(width, width);
    painter.fillRect(QRectF(a - w, QPointF(b.x() + width, a.y() + width)), colour);
    painter.fillRect(QRectF(QPointF(a.x() - width, b.y() - width), b + w), colour);
    painter.fillRect(QRectF(a - w, QPointF(a.x() + width, b.y() + width)), colour);
    painter.fillRect(QRectF(QPointF(b.x() - width, a.y() - width), b + w), colour);
  };
  frame(2 * half, dark);
  frame(half, pink);
  const QPointF middle = 0.5 * (a + b);
  for (const double x : {a.x(), std::round(middle.x()), b.x()}) {
    for (const double y : {a.y(), std::round(middle.y()), b.y()}) {
      if (x == std::round(middle.x()) && y == std::round(middle.y())) continue;
      for (const auto& [reach, colour] : {std::pair{5 * half, dark}, {4 * half, pink}}) {
        painter.fillRect(QRectF(x - reach, y - reach, 2 * reach, 2 * reach), colour);
      }
    }
  }
}

}  // namespace relievo
