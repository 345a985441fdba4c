// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/depth/depth_map.h"
#include "core/describe/sayable.h"
#include "core/message/message.h"
#include "core/region/region_window.h"

namespace relievo {

struct Surface;  // core/session/surface.h

/// A part of the relief that stands above the rest.
struct RaisedArea {
  double x_mm = 0, y_mm = 0;           ///< Its centroid, view mm.
  double width_mm = 0, height_mm = 0;  ///< Of the box around it.
  double share = 0;                    ///< Of the surface.
  Ninth ninth = Ninth::middle;
  bool is_rim = false;  ///< It reaches all four sides of the object, and leaves out its middle.
};

/// What can honestly be said of a relief from its heights alone; never what it depicts, what it is
/// made of, or how old it is. Facts are of the whole object as it is felt at Detail 1, 200 samples
/// across, so that they are the same whatever the map's size is and wherever its cells are; but
/// for the size, the range of heights and the shares, which are of the finest cells. What does not
/// come out clearly is left out (docs/adr/0162).
struct Description {
  RectMm object;        ///< View mm.
  HeightRange heights;  ///< Of the finest cells.
  bool has_heights = false;
  /// Between the 2nd and the 98th of a hundred samples: what a stray sample does not change.
  double most_span_mm = 0;

  struct Highest {
    double x_mm = 0, y_mm = 0, height_mm = 0;
    Ninth ninth = Ninth::middle;
  };
  /// Nothing: samples as high, within a twentieth of the span, lie elsewhere, too.
  std::optional<Highest> highest;

  /// How clearly the heights fall into two groups (Otsu's share of the variance between them),
  /// 0 .. 1, and where they part.
  double separability = 0, threshold_mm = 0;
  /// Largest first; empty: there are none, or how many there are depends on where one looks.
  std::vector<RaisedArea> raised;

  /// Correlation of the heights with their mirror image, -1 .. 1; nothing without a height.
  std::optional<double> mirrored_sides, mirrored_ends;

  /// By Ninth: the median by which a sample leaves its neighbourhood, mm; < 0: too few samples.
  std::array<double, kNinths> roughness_mm{};
  /// At least three times as rough as the median of the others; and a third of it.
  std::optional<Ninth> roughest, smoothest;

  double not_measured = 0;           ///< Share of the surface, of the finest cells; 0 .. 1.
  std::optional<Ninth> largest_gap;  ///< Of at least a hundredth of the surface.
};

/// @param whole  the whole object's window at gain 1
/// @param shares  of the finest cells, by origin
Description describe(const RegionWindow& whole, const RectMm& object, const HeightRange& heights,
                     const std::array<double, kOriginCount>& shares);
/// The same of any surface, in memory or by tiles. [any thread] @throw FileError
Description describe(const Surface& surface);

/// Sentences, each with its form for ears; the most telling first.
std::vector<Message> sentencesOf(const Description& description);

}  // namespace relievo
