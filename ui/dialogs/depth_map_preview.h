// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <QImage>
#include <QWidget>
#include <vector>

#include "core/session/surface.h"

namespace relievo {

/// What a depth map looks like before it is taken: pictures and counts, made once off the GUI
/// thread.
struct DepthMapPicture {
  QImage shaded;            ///< Hillshaded; outside is transparent.
  QImage mask;              ///< Same size: what was not measured, by colour and pattern.
  std::vector<int> counts;  ///< Of measured cells by height, from low to high.
  double low_mm = 0, high_mm = 0;
  std::array<double, kOriginCount> shares{};
};
/// [worker] @throw Cancelled
DepthMapPicture pictureOf(const Surface& surface, const Task& task = {});

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
