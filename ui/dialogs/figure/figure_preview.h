// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QImage>
#include <QLabel>

namespace relievo {

/// A picture as large as its place allows, whole and in its proportions. [GUI thread]
class FigurePreview : public QLabel {
  Q_OBJECT
 public:
  explicit FigurePreview(QWidget* parent = nullptr);

  void setPicture(const QImage& picture);
  /// Of the place's longer side, in pixels of the screen.
  int longestPx() const;

 Q_SIGNALS:
  void resized();

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void fit();

  QImage picture_;
};

}  // namespace relievo
