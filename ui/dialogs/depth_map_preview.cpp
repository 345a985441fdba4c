// SPDX-License-Identifier: BSD-3-Clause
#include "ui/dialogs/depth_map_preview.h"

#include <algorithm>
#include <cmath>
#include <QFontMetrics>
#include <QPainter>

#include "ui/style/palette.h"
#include "ui/style/text.h"

namespace relievo {

DepthMapPreview::DepthMapPreview(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("depth_preview"));
  setAccessibleName(tr("Preview of the depth map"));
  setMinimumSize(200, 150);
}

void DepthMapPreview::setPicture(const DepthMapPicture& picture) {
  picture_ = picture;
  update();
}

void DepthMapPreview::setMaskShown(bool shown) {
  mask_shown_ = shown;
  update();
}

void DepthMapPreview::setStale(bool stale) {
  stale_ = stale;
  setAccessibleDescription(stale ? tr("Of other choices than those shown")
                                 : tr("Of the choices shown"));
  update();
}

void DepthMapPreview::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.fillRect(rect(), currentColours().viewport);
  if (!picture_.shaded.isNull()) {
    const QSize fitted = picture_.shaded.size().scaled(size(), Qt::KeepAspectRatio);
    const QRect place(QPoint((width() - fitted.width()) / 2, (height() - fitted.height()) / 2),
                      fitted);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.setOpacity(stale_ ? 0.35 : 1);
    painter.drawImage(place, picture_.shaded);
    if (mask_shown_) painter.drawImage(place, picture_.mask);
    painter.setOpacity(1);
  }
  if (!stale_) return;
  const QString text = tr("Not of these choices yet");
  const QRect box = QFontMetrics(font()).boundingRect(text).adjusted(-10, -6, 10, 6);
  const QRect plate(rect().center() - QPoint(box.width() / 2, box.height() / 2), box.size());
  painter.fillRect(plate, currentColours().strip);
  painter.setPen(currentColours().text);
  painter.drawText(plate, Qt::AlignCenter, text);
}

HeightHistogram::HeightHistogram(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("height_histogram"));
  setAccessibleName(tr("Heights of measured cells"));
  setMinimumHeight(60);
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
}

void HeightHistogram::setPicture(const DepthMapPicture& picture) {
  counts_ = picture.counts;
  low_mm_ = picture.low_mm;
  high_mm_ = picture.high_mm;
  const double step = (high_mm_ - low_mm_) / 100;
  setAccessibleDescription(
      tr("From %1 to %2 mm").arg(mmText(low_mm_, step), mmText(high_mm_, step)));
  update();
}

void HeightHistogram::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  const ThemeColours& c = currentColours();
  painter.fillRect(rect(), c.base);
  if (counts_.empty()) return;
  const int text_height = painter.fontMetrics().height();
  const QRectF plot = QRectF(rect()).adjusted(6, 4, -6, -4.0 - text_height);
  const int most = std::max(1, *std::max_element(counts_.begin(), counts_.end()));
  const double bar = plot.width() / static_cast<double>(counts_.size());
  for (std::size_t i = 0; i < counts_.size(); ++i) {
    // The square root keeps a rare height visible beside a broad ground.
    const double share = std::sqrt(static_cast<double>(counts_[i]) / most);
    painter.fillRect(
        QRectF(plot.left() + bar * static_cast<double>(i), plot.bottom() - share * plot.height(),
               std::max(1.0, bar - 1), share * plot.height()),
        c.highlight);
  }
  painter.setPen(c.quiet_text);
  painter.drawLine(plot.bottomLeft(), plot.bottomRight());
  const double step = (high_mm_ - low_mm_) / 100;
  const QRect line(6, height() - text_height - 1, width() - 12, text_height);
  painter.drawText(line, Qt::AlignLeft, tr("%1 mm").arg(mmText(low_mm_, step)));
  painter.drawText(line, Qt::AlignHCenter, tr("height"));
  painter.drawText(line, Qt::AlignRight, tr("%1 mm").arg(mmText(high_mm_, step)));
}

}  // namespace relievo
