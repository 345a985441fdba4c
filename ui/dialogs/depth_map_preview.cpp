// SPDX-License-Identifier: BSD-3-Clause
#include "ui/dialogs/depth_map_preview.h"

#include <algorithm>
#include <cmath>
#include <QFontMetrics>
#include <QPainter>

#include "core/relief/relief_image.h"
#include "ui/style/palette.h"
#include "ui/style/text.h"

namespace relievo {
namespace {

constexpr int kMostPixels = 720;
constexpr int kBins = 96;

/// Every k-th sample of the map, so that a picture of it costs no more than it shows.
DepthMap thinned(const DepthMap& map) {
  const GridSize size = map.frame.size;
  const int step = 1 + (std::max(size.cols, size.rows) - 1) / kMostPixels;
  if (step == 1) return map;
  DepthMap thin;
  thin.frame = map.frame;
  thin.frame.spacing_mm *= step;
  thin.frame.size = {(size.cols - 1) / step + 1, (size.rows - 1) / step + 1};
  for (int row = 0; row < size.rows; row += step) {
    for (int col = 0; col < size.cols; col += step) {
      thin.heights_mm.push_back(map.heightMm({col, row}));
      thin.origins.push_back(map.origin({col, row}));
    }
  }
  return thin;
}

/// Colour and pattern of what was not measured; transparent for the rest.
QRgb maskPixel(CellStatus origin, int x, int y) {
  const bool stripe = (x + y) % 6 < 2;
  const bool crossed = stripe || (x - y + 6 * kMostPixels) % 6 < 2;
  switch (origin) {
    case CellStatus::interpolated:
      return stripe ? qRgba(60, 120, 220, 255) : qRgba(60, 120, 220, 90);
    case CellStatus::base_plane:
      return crossed ? qRgba(150, 40, 110, 255) : qRgba(150, 40, 110, 110);
    case CellStatus::steep:
      return qRgba(230, 140, 20, 200);
    case CellStatus::measured:
    case CellStatus::outside:
      break;
  }
  return qRgba(0, 0, 0, 0);
}

}  // namespace

DepthMapPicture pictureOf(const Surface& surface, const Task& task) {
  DepthMapPicture picture;
  picture.shares = originShares(surface.map);
  const DepthMap map = thinned(surface.map);
  const ReliefLook look{.kind = ReliefKind::hillshade};
  const ReliefValues shade = reliefValues(map, look, task);
  const GridSize size = map.frame.size;
  picture.shaded = QImage(size.cols, size.rows, QImage::Format_ARGB32);
  picture.mask = QImage(size.cols, size.rows, QImage::Format_ARGB32);
  float low = 0;
  float high = 0;
  bool first = true;
  for (std::size_t i = 0; i < map.heights_mm.size(); ++i) {
    if (map.origins[i] != CellStatus::measured) continue;
    low = first ? map.heights_mm[i] : std::min(low, map.heights_mm[i]);
    high = first ? map.heights_mm[i] : std::max(high, map.heights_mm[i]);
    first = false;
  }
  picture.counts.assign(kBins, 0);
  const float per_mm = high > low ? kBins / (high - low) : 0;
  for (int row = 0; row < size.rows; ++row) {
    // A picture's first row is at the top.
    auto* shaded = reinterpret_cast<QRgb*>(picture.shaded.scanLine(size.rows - 1 - row));
    auto* mask = reinterpret_cast<QRgb*>(picture.mask.scanLine(size.rows - 1 - row));
    for (int col = 0; col < size.cols; ++col) {
      const std::size_t i = size.index({col, row});
      const CellStatus origin = map.origins[i];
      const int grey = std::isfinite(shade.values[i])
                           ? static_cast<int>(30 + 215 * std::clamp(shade.values[i], 0.0F, 1.0F))
                           : 0;
      shaded[col] =
          origin == CellStatus::outside ? qRgba(0, 0, 0, 0) : qRgba(grey, grey, grey, 255);
      mask[col] = maskPixel(origin, col, row);
      if (origin != CellStatus::measured) continue;
      const int bin = static_cast<int>((map.heights_mm[i] - low) * per_mm);
      ++picture.counts[static_cast<std::size_t>(std::clamp(bin, 0, kBins - 1))];
    }
  }
  picture.low_mm = static_cast<double>(low);
  picture.high_mm = static_cast<double>(high);
  return picture;
}

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
