// SPDX-License-Identifier: BSD-3-Clause
#include "ui/views/overlays/suggestion_frames.h"

#include <QPainter>
#include <utility>

namespace relievo {

SuggestionFrames::SuggestionFrames(QWidget* view, std::function<QPointF(double, double)> point_of)
    : QWidget(view), point_of_(std::move(point_of)) {
  setObjectName(QStringLiteral("suggestion_frames"));
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setAttribute(Qt::WA_NoSystemBackground);
  hide();
}

void SuggestionFrames::setFrames(const std::vector<SuggestedFrame>& frames) {
  if (frames == frames_) return;
  frames_ = frames;
  place();
}

void SuggestionFrames::place() {
  setGeometry(parentWidget()->rect());
  setVisible(!frames_.empty());
  update();
}

/// Dashed, so that none is taken for the window itself, whose frame is whole and pink.
void SuggestionFrames::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  const QFontMetrics metrics = fontMetrics();
  const QColor dark(18, 18, 20), bright(255, 209, 64);
  // The best last: nothing lies over it.
  for (std::size_t i = frames_.size(); i-- > 0;) {
    const RectMm& r = frames_[i].rect;
    const QRectF frame(point_of_(r.x_mm, r.y_mm + r.height_mm),
                       point_of_(r.x_mm + r.width_mm, r.y_mm));
    const double line = frames_[i].is_current ? 2.5 : 1.5;
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(dark, line + 2));
    painter.drawRect(frame);
    painter.setPen(QPen(bright, line, frames_[i].is_current ? Qt::SolidLine : Qt::DashLine));
    painter.drawRect(frame);
    const QString rank = QString::number(i + 1);
    QRectF tag(frame.topLeft(), QSizeF(metrics.horizontalAdvance(rank) + 8, metrics.height() + 2));
    // Within the view, also where the frame begins outside of it.
    tag.moveTopLeft({qBound(0.0, tag.left(), qMax(0.0, width() - tag.width())),
                     qBound(0.0, tag.top(), qMax(0.0, height() - tag.height()))});
    painter.fillRect(tag, bright);
    painter.setPen(dark);
    painter.drawText(tag, Qt::AlignCenter, rank);
  }
}

}  // namespace relievo
