// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QImage>

#include "core/relief/relief_image.h"
#include "ui/figure/figure_layout.h"

namespace relievo {

/// A panel's picture and what its colours mean.
struct PanelPicture {
  QImage image;         ///< Premultiplied ARGB.
  ReliefValues values;  ///< Without the values themselves: title, unit and the colours' ends.
  double eye_angle_deg = 0, parallax_deg = 0, zero_plane_mm = 0;
};

/// The samples of a level within a rectangle and `margin` samples around it, heights times `gain`;
/// every sample's origin is that of the finest cell nearest to it. @throw ArgumentError  more
/// samples than can be drawn, or none
DepthMap cutOut(const Surface& surface, Level level, const RectMm& rect, int margin, double gain);

/// [any thread that may use OpenGL] @throw GraphicsError, Cancelled, ArgumentError
PanelPicture drawPanel(const Surface& surface, const Project& project, const FigurePanel& panel,
                       const FigureSheet& sheet, const QSize& pixels, double dpi, const Task& task);

}  // namespace relievo
