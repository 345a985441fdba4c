// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "core/recording/force_curve.h"
#include "ui/figure/figure.h"
#include "ui/figure/figure_ink.h"
#include "ui/figure/figure_pictures.h"
#include "ui/figure/mark_places.h"

namespace relievo {

/// A figure whose pictures are drawn: what is left is to put it on pixels or on paper.
struct DrawnSheet {
  FigureSheet layout;
  std::vector<PanelPicture> pictures;  ///< One for each panel.
  std::vector<Reading> measured;       ///< One for each measurement that is drawn.
  std::vector<PanelMarks> marks;       ///< Of each panel.
  std::vector<ForcePoint> recording;
  double dpi = 300;
  FigureFacts facts;
};

/// @param dpi  instead of the request's
/// @throw as drawFigure
DrawnSheet drawPictures(const Surface& surface, const Project& project, double dpi,
                        const Task& task);

/// The caption of a figure, from what its facts say of scale and stereo.
std::string figureCaption(const Surface& surface, const Project& project, const FigureFacts& facts);

/// Pictures, marks, plots and legend. The painter's unit is 1/dpi inch.
void paintSheet(QPainter& painter, const Surface& surface, const Project& project,
                const DrawnSheet& sheet, FigureInk::Target target);

}  // namespace relievo
