// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/measure/measure.h"
#include "core/session/surface.h"
#include "ui/figure/figure_ink.h"
#include "ui/figure/figure_layout.h"

namespace relievo {

/// One panel on paper: from the object's millimetres to the paper's pixels.
class PanelSpace {
 public:
  PanelSpace(const FigureInk& ink, const FigurePanel& panel);
  const QRectF& box() const { return box_; }
  double mmPerPx() const { return mm_per_px_; }
  double inset() const { return inset_; }  ///< Of marks from the panel's edge, pixels.
  QPointF at(double x_mm, double y_mm) const;

 private:
  QRectF box_;
  RectMm shown_;
  double mm_per_px_ = 1;
  double inset_ = 0;
};

/// Words of a mark; sizes are times the figure's text size.
struct MarkWords {
  QPointF at;  ///< The baseline's left end or middle, pixels.
  QString text;
  bool centred = false;
  double size = 1;
  bool bold = false;
};

/// A plate in a panel and what stands on it.
struct PlacedMark {
  enum class Kind { scale_bar, letter, up, height_bar, measurement };
  Kind kind = Kind::scale_bar;
  QRectF box;
  QRectF bar = {};  ///< Of ink; empty: none.
  std::vector<MarkWords> words;
};

/// The marks of one panel: each whole within it, no two over each other.
struct PanelMarks {
  std::vector<PlacedMark> marks;
  std::vector<std::string> left_out;  ///< For which there is no room.
};

/// What the places depend on.
struct MarkedSheet {
  const Surface& surface;
  const Project& project;
  const FigureSheet& layout;
  const std::vector<Reading>& measured;  ///< One for each measurement that is drawn.
};

/// The scale bar is always there, in smaller type if it must; others give way: the height bar
/// stands above it or gets shorter, words go on in a second line. The same at every density but
/// for whole pixels.
/// @return  of each panel
std::vector<PanelMarks> placeMarks(const FigureInk& ink, const MarkedSheet& sheet);

/// A sentence on the marks for which there is no room; empty if there is none such.
std::string leftOutText(const std::vector<PanelMarks>& panels);

/// Text in lines of at most `room` pixels, broken after commas if that is enough, else between
/// words; nothing if a word is wider.
std::vector<QString> wrapped(const FigureInk& ink, const QString& text, double room,
                             double size = 1);

}  // namespace relievo
