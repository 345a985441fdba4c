// SPDX-License-Identifier: BSD-3-Clause
#include "ui/views/overlays/colour_bar.h"

#include <algorithm>
#include <cmath>
#include <QPainter>

#include "ui/language/core_text.h"
#include "ui/style/text.h"
#include "ui/views/overlays/corner.h"

namespace relievo {

ColourBar::ColourBar(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("colour_bar"));
  setAccessibleName(tr("Bar of colours"));
  setAttribute(Qt::WA_TransparentForMouseEvents);
  hide();
}

void ColourBar::show(const ReliefValues& values, const ReliefLook& look) {
  look_ = look;
  low_ = values.low;
  high_ = values.high;
  title_ = coreText(values.title);
  if (!values.unit.empty()) {
    title_ += QStringLiteral(" (%1)").arg(
        QString::fromUtf8(values.unit.data(), static_cast<int>(values.unit.size())));
  }
  setAccessibleDescription(tr("%1 from %2 to %3").arg(title_, endText(low_), endText(high_)));
  wanted_ = hasLegend(look.kind);
  setVisible(wanted_ && !showsHalves(print_));
  place();
  update();
}

/// The ends are round: no more decimals than both of them need.
QString ColourBar::endText(double value) const {
  constexpr int kMostDecimals = 6;
  const double near = 1e-3 * (high_ - low_);
  int decimals = 0;
  for (double scale = 1; decimals < kMostDecimals; ++decimals, scale *= 10) {
    const auto rest = [scale](double v) { return std::abs(std::round(v * scale) / scale - v); };
    if (rest(low_) <= near && rest(high_) <= near) break;
  }
  return numberText(value, decimals);
}

void ColourBar::setPrint(StereoPrint print) {
  if (print == print_) return;
  print_ = print;
  setVisible(wanted_ && !showsHalves(print_));
  update();
}

void ColourBar::leave() {
  wanted_ = false;
  hide();
}

std::array<std::uint8_t, 3> ColourBar::colourAt(double share) const {
  return mixedColour(print_, colourOf(coloursOf(look_), share));
}

void ColourBar::place() {
  const int line = fontMetrics().height();
  const QSize size(std::max(12 * line, fontMetrics().horizontalAdvance(title_) + 10 * line),
                   2 * line + 3 * kCornerPadding);
  const QSize fitted(std::min(size.width(), parentWidget()->width() / 2), size.height());
  setGeometry(QRect(QPoint(parentWidget()->width() - fitted.width() - kCornerMargin,
                           parentWidget()->height() - fitted.height() - kCornerMargin),
                    fitted));
}

void ColourBar::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.fillRect(rect(), QColor(18, 18, 20, 150));
  const int line = fontMetrics().height();
  const QRect bar(kCornerPadding, kCornerPadding, width() - 2 * kCornerPadding, line);
  for (int x = 0; x < bar.width(); ++x) {
    const auto c = colourAt((x + 0.5) / bar.width());
    painter.fillRect(bar.left() + x, bar.top(), 1, bar.height(), QColor(c[0], c[1], c[2]));
  }
  painter.setPen(QColor(245, 245, 245));
  const QRect words = bar.translated(0, line + kCornerPadding);
  painter.drawText(words, Qt::AlignLeft, endText(low_));
  painter.drawText(words, Qt::AlignHCenter, title_);
  painter.drawText(words, Qt::AlignRight, endText(high_));
}

}  // namespace relievo
