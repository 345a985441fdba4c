// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/vec3.h"
#include "core/region/region_window.h"

namespace relievo {

/// What a line goes round.
enum class OutlineOf : std::uint8_t {
  raised,  ///< An area that stands out of the relief.
  sunk,    ///< One that lies below its surroundings.
  object,  ///< The object, or a part of its border that lies within it.
};

/// A closed line on a relief that a hand can be led along.
struct Outline {
  OutlineOf of = OutlineOf::raised;
  /// View mm; the first is not said again. On the level; of the object on its smoothed border.
  std::vector<ViewMm> corners;
  double level_mm = 0;  ///< Height of the level line; of the object: 0.
  double share = 0;     ///< Of the window's square that it encloses.

  double lengthMm() const;
};

/// No area smaller than this share of the window is led along.
inline constexpr double kLeastOutlineShare = 0.01;
/// A line keeps its shape to this, mm of hand.
inline constexpr double kOutlineToleranceMm = 0.3;

/// Edges of areas that stand out of a window, or are sunk into it; the largest first. Heights are
/// the means of 3 x 3 samples. Of 23 levels between the 5th and the 98th of a hundred heights, with
/// as many closed lines as Otsu's threshold (two_groups.h) has, it is the one whose lines run where
/// the relief is steepest. Nothing if there are more than five, or another number a tenth of the
/// span above or below the threshold: then it depends on where one looks. A line that meets the
/// window's border or ground that was not measured is not closed and is none: an edge is told only
/// where it was seen all round.
/// @param tolerance_mm  view mm, > 0 (kOutlineToleranceMm at the scale of the hand)
std::vector<Outline> raisedOutlines(const RegionWindow& window, double tolerance_mm);

/// The border between what belongs to the object and what lies outside of it.
/// @param edges  sides on which the window ends where the map does, as edgesOf() says: there the
///               border may follow the window's; elsewhere a border that leaves the window is open
std::vector<Outline> objectOutlines(const RegionWindow& window, std::uint8_t edges,
                                    double tolerance_mm);

/// All of them: areas, then the object. [any thread]
std::vector<Outline> outlinesOf(const RegionWindow& window, std::uint8_t edges,
                                double tolerance_mm);

/// Which one a hand at x, y is nearest to, in the plane of the window; null: there are none.
const Outline* nearestOutline(const std::vector<Outline>& outlines, double x_mm, double y_mm);

}  // namespace relievo
