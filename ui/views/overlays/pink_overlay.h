// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <QRectF>
#include <QWidget>

namespace relievo {

/// The pink window's frame and handles over a view's picture, as ReliefScene draws them into files.
/// Drawn by Qt, so that a frame that is dragged costs no picture of the relief below it. Lets the
/// pointer through. [GUI thread]
class PinkOverlay : public QWidget {
  Q_OBJECT
 public:
  explicit PinkOverlay(QWidget* view);
  /// In points of the view; nothing: no frame.
  void setFrame(const std::optional<QRectF>& frame);
  const std::optional<QRectF>& frame() const { return frame_; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  std::optional<QRectF> frame_;
};

}  // namespace relievo
