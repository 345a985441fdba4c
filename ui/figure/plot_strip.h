// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/recording/force_curve.h"
#include "ui/vtk/offscreen.h"

namespace relievo {

/// The paper's force figure as a part of moving pictures: the curves stand still, a cursor goes
/// through them. Needs a FigureSession. [one thread]
class PlotStrip {
 public:
  /// @param rows  at least one, times increase
  PlotStrip(const std::vector<ForcePoint>& rows, int width_px, int height_px);
  ~PlotStrip();
  PlotStrip(const PlotStrip&) = delete;
  PlotStrip& operator=(const PlotStrip&) = delete;

  /// @param words  one line above the curves
  RgbaImage draw(double t_s, const std::string& words) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace relievo
