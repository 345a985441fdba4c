// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "core/relief/relief_image.h"
#include "core/session/surface.h"
#include "ui/figure/figure_ink.h"
#include "ui/figure/figure_layout.h"

namespace relievo {

/// Bar of colours and swatches of hatches with their shares, in as many rows as they need at the
/// text's size.
class FigureLegend {
 public:
  /// @param values  that the bar explains; not asked for without colours
  /// @param room  the sheet's width, pixels
  FigureLegend(const FigureInk& ink, const Surface& surface, const Project& project,
               const ReliefValues& values, double room);
  ~FigureLegend();
  FigureLegend(const FigureLegend&) = delete;
  FigureLegend& operator=(const FigureLegend&) = delete;

  double width() const, height() const;  ///< Pixels.
  /// Times the figure's: 1 but where a single word or two numbers are wider than the sheet.
  double textSize() const;
  void draw(FigureInk& ink, const QPointF& corner) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace relievo
