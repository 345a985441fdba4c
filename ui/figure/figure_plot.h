// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/project/force_curve.h"
#include "ui/figure/figure_ink.h"

namespace relievo {

/// The paper's force figure: heights of HIP (red, dashed) and proxy (blue) above, the force below,
/// against time. Boxes in millimetres of paper; numbers stand left of and below them.
void drawForcePlots(FigureInk& ink, const std::vector<ForceCurveRow>& rows, const QRectF& heights,
                    const QRectF& forces);

/// A curve (x, y) with axes named after their units, for a profile.
void drawCurve(FigureInk& ink, const std::vector<QPointF>& curve, const QRectF& box,
               const QString& x_title, const QString& y_title);

}  // namespace relievo
