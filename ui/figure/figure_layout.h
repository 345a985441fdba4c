// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <QRectF>
#include <QString>
#include <vector>

#include "core/project/project.h"

namespace relievo {

/// One picture of a figure. Millimetres of paper from the figure's top left corner.
struct FigurePanel {
  QRectF paper;
  RectMm shown;              ///< Of the object, view mm; the same aspect.
  Level level;               ///< That feeds it.
  bool whole = false;        ///< The reference, with the window's outline.
  bool as_measured = false;  ///< Leaves out what is not measured.
  int eye = 0;               ///< -1 left, +1 right, 0 as the request's stereo says.
  QString title;             ///< Beside the letter; may be empty.
};

struct FigureSheet {
  double width_mm = 0, height_mm = 0;
  std::vector<FigurePanel> panels;  ///< The region's is the last but for stereo pairs and levels.
  QRectF heights_plot, force_plot;  ///< With their numbers; empty without a recording.
  QRectF legend;                    ///< Empty if nothing needs explaining; one row, until its
                                    ///< numbers are known.
  double paper_per_mm = 1;          ///< Of the region's panels.
};

/// Millimetres per point.
inline constexpr double kMmPerPoint = 25.4 / 72;

/// The request's look with what it leaves open, in millimetres: the same in every panel.
ReliefLook figureLook(const Surface& surface, const Project& project);

/// What the legend of hatches states: shares of the whole object where the figure shows it, else of
/// the region's cells, as in the caption.
struct LegendShares {
  std::array<double, kOriginCount> shares{};
  bool of_object = false;
};
LegendShares legendShares(const Surface& surface, const Project& project);

/// Where everything goes. @throw ArgumentError  a scale that needs a sheet beyond 2 m, or one
/// narrower than 20 mm
FigureSheet layOut(const Surface& surface, const Project& project);

}  // namespace relievo
