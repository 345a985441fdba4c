// SPDX-License-Identifier: BSD-3-Clause
#include "ui/figure/figure_ink.h"

#include <algorithm>
#include <cmath>
#include <QFontMetricsF>
#include <QPainterPath>

namespace relievo {
namespace {

constexpr int kFontPx = 256;  // Outlines are taken at this size and scaled: no hinting shows.

QFont font(bool bold) {
  QFont f(QStringLiteral("DejaVu Sans"));
  f.setStyleHint(QFont::SansSerif);
  f.setHintingPreference(QFont::PreferNoHinting);
  f.setPixelSize(kFontPx);
  f.setBold(bold);
  f.setKerning(false);
  return f;
}

}  // namespace

FigureInk::FigureInk(QPainter& painter, double dpi, double text_pt, Target target)
    : painter_(painter), dpi_(dpi), text_pt_(text_pt), target_(target) {
  painter_.setRenderHint(QPainter::Antialiasing);
}

QRect FigureInk::pixels(const QRectF& mm) const {
  const auto whole = [this](double value) { return static_cast<int>(std::lround(px(value))); };
  const int left = whole(mm.left());
  const int top = whole(mm.top());
  return {left, top, std::max(1, whole(mm.right()) - left), std::max(1, whole(mm.bottom()) - top)};
}

QPen FigureInk::pen(const QColor& colour, double points) const {
  QPen p(colour, pt(points));
  p.setCapStyle(Qt::FlatCap);
  p.setJoinStyle(Qt::MiterJoin);
  return p;
}

double FigureInk::width(const QString& text, double size) const {
  return QFontMetricsF(font(false)).horizontalAdvance(text) * pt(size * text_pt_) / kFontPx;
}

void FigureInk::text(QPointF at, const QString& text, Qt::Alignment alignment, double size,
                     bool bold) {
  const QFont f = font(bold);
  const double scale = pt(size * text_pt_) / kFontPx;
  const double advance = QFontMetricsF(f).horizontalAdvance(text) * scale;
  if ((alignment & Qt::AlignHCenter) != 0) at.rx() -= 0.5 * advance;
  if ((alignment & Qt::AlignRight) != 0) at.rx() -= advance;
  painter_.save();
  painter_.translate(at);
  painter_.scale(scale, scale);
  if (target_ == Target::pixels) {
    QPainterPath outlines;
    outlines.addText(0, 0, f, text);
    painter_.fillPath(outlines, kInk);
  } else {
    painter_.setFont(f);
    painter_.setPen(kInk);
    painter_.drawText(QPointF(0, 0), text);
  }
  painter_.restore();
}

void FigureInk::uprightText(QPointF at, const QString& words) {
  painter_.save();
  painter_.translate(at);
  painter_.rotate(-90);
  text({0, 0}, words, Qt::AlignHCenter);
  painter_.restore();
}

}  // namespace relievo
