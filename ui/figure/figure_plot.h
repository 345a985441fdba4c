// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/recording/force_curve.h"
#include "ui/figure/figure_ink.h"

namespace relievo {

/// Two plots, one above the other, millimetres of paper.
struct ForcePlots {
  QRectF heights, forces;
};
/// Between two of them, and between a plot and a picture above it, times the text's size: a number
/// at the end of either axis needs half its height.
inline constexpr double kPlotGapEm = 1.3;

/// The paper's force figure: heights of HIP (red, dashed) and proxy (blue) above, the force below,
/// against time.
/// @param papers  the plots with the numbers left and right of them; those of time stand below
/// @return  the plots' own boxes
ForcePlots drawForcePlots(FigureInk& ink, const std::vector<ForcePoint>& rows,
                          const ForcePlots& papers);

/// A curve (x, y) in pieces, left to right, with axes named after their units: of a profile that
/// leaves the object and comes back. None of the pieces is empty.
void drawCurve(FigureInk& ink, const std::vector<std::vector<QPointF>>& pieces, const QRectF& box,
               const QString& x_title, const QString& y_title);

}  // namespace relievo
