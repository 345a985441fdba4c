// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <QImage>
#include <QWidget>

namespace relievo {

/// A picture that was copied out of OpenGL's memory, as an ordinary widget. Where OpenGL is
/// software, Qt's way of showing a widget of OpenGL's costs more than the picture itself:
/// docs/adr/0225. Mouse and keys go to its parent. [GUI thread]
class CopiedPicture : public QWidget {
  Q_OBJECT
 public:
  explicit CopiedPicture(QWidget* parent);

  /// To be filled, every pixel of it, and shown by update(); it is spread over the widget.
  QImage& pixels(const QSize& size);
  const QImage& image() const { return image_; }
  /// Called when it comes on screen, and before it is painted.
  void follow(std::function<void()> shown, std::function<void()> wanted);

 Q_SIGNALS:
  void painted();

 protected:
  void showEvent(QShowEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  std::function<void()> shown_, wanted_;
  QImage image_;
};

}  // namespace relievo
