// SPDX-License-Identifier: BSD-3-Clause
#include "ui/dialogs/figure/figure_preview.h"

#include <algorithm>
#include <cmath>
#include <QPixmap>

namespace relievo {

FigurePreview::FigurePreview(QWidget* parent) : QLabel(parent) {
  setAlignment(Qt::AlignCenter);
  setMinimumSize(240, 160);
  setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Ignored);
}

void FigurePreview::setPicture(const QImage& picture) {
  picture_ = picture;
  fit();
}

int FigurePreview::longestPx() const {
  return static_cast<int>(std::ceil(std::max(width(), height()) * devicePixelRatioF()));
}

void FigurePreview::resizeEvent(QResizeEvent* event) {
  QLabel::resizeEvent(event);
  fit();
  Q_EMIT resized();
}

void FigurePreview::fit() {
  if (picture_.isNull()) return;
  QPixmap fitted = QPixmap::fromImage(
      picture_.scaled(size() * devicePixelRatioF(), Qt::KeepAspectRatio, Qt::SmoothTransformation));
  fitted.setDevicePixelRatio(devicePixelRatioF());
  setPixmap(fitted);
}

}  // namespace relievo
