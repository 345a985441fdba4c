// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

#include "core/session/surface.h"

namespace relievo {

/// A unit as people read it, and how many of what is computed with make one.
struct ShownUnit {
  std::string_view name;
  double size = 1;
};

/// The units in which one object's lengths, areas and volumes are told to people: those of its
/// scale bar, millimetres for what lies on a table, metres for terrain. Files keep millimetres.
class ShownLengths {
 public:
  explicit ShownLengths(double longer_side_mm);
  explicit ShownLengths(const Surface& surface);

  /// Of places, distances and heights.
  const ShownUnit& unit() const { return unit_; }
  /// The same, or km where a length on terrain is one or more.
  ShownUnit unitOf(double mm) const;
  /// The unit that takes the place of a unit of ours: m\u00b2 for mm\u00b2 on terrain; others stay.
  ShownUnit unitFor(std::string_view ours) const;

  /// A length without its unit.
  std::string number(double mm) const;
  /// A length and its unit, "0.25 mm", "1.2 km".
  std::string text(double mm, int digits = 4) const;
  /// Width and height of a rectangle, "1.2 \u00d7 0.8 km".
  std::string rectangle(double width_mm, double height_mm) const;

 private:
  ShownUnit unit_;
};

}  // namespace relievo
