// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QWidget>
#include <vector>

#include "ui/work/pictures/depth_map_picture.h"

namespace relievo {

/// Shows a picture, fitted, with the mask over it if asked. [GUI thread]
class DepthMapPreview : public QWidget {
  Q_OBJECT
 public:
  explicit DepthMapPreview(QWidget* parent = nullptr);
  void setPicture(const DepthMapPicture& picture);
  void setMaskShown(bool shown);
  /// The picture is of other choices than those on show.
  void setStale(bool stale);
  QSize sizeHint() const override { return {420, 320}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  DepthMapPicture picture_;
  bool mask_shown_ = true;
  bool stale_ = true;
};

/// How often each height was measured. [GUI thread]
class HeightHistogram : public QWidget {
  Q_OBJECT
 public:
  explicit HeightHistogram(QWidget* parent = nullptr);
  void setPicture(const DepthMapPicture& picture);
  QSize sizeHint() const override { return {420, 90}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  std::vector<int> counts_;
  double low_mm_ = 0, high_mm_ = 0;
};

}  // namespace relievo
