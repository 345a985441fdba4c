// SPDX-License-Identifier: BSD-3-Clause
#include "ui/views/copied_picture.h"

#include <QPainter>
#include <utility>

namespace relievo {

CopiedPicture::CopiedPicture(QWidget* parent) : QWidget(parent) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setAttribute(Qt::WA_OpaquePaintEvent);
  setFocusPolicy(Qt::NoFocus);
  hide();
}

QImage& CopiedPicture::pixels(const QSize& size) {
  if (image_.size() != size) image_ = QImage(size, QImage::Format_RGB32);
  return image_;
}

void CopiedPicture::follow(std::function<void()> shown, std::function<void()> wanted) {
  shown_ = std::move(shown);
  wanted_ = std::move(wanted);
}

void CopiedPicture::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  if (shown_) shown_();
}

void CopiedPicture::paintEvent(QPaintEvent* /*event*/) {
  if (wanted_) wanted_();
  QPainter painter(this);
  const QSize here = size() * devicePixelRatioF();
  painter.setRenderHint(QPainter::SmoothPixmapTransform, image_.size() != here);
  painter.setCompositionMode(QPainter::CompositionMode_Source);
  painter.drawImage(rect(), image_);
  Q_EMIT painted();
}

}  // namespace relievo
