// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "core/measure/measure.h"

namespace relievo {

/// The proxy at one moment.
struct TouchSample {
  PlaceMm proxy;  ///< View.
  double force_n = 0;
  bool touching = false;
};

/// What a contact marked on the surface: one place if it was a tap, a line if it was a stroke.
struct TouchMark {
  std::vector<PlaceMm> places;
  bool stroke = false;
};

/// Makes marks of the proxy's way, a mark at the end of each contact. A contact that never leaves
/// the neighbourhood of its beginning is a tap, and its place is where the hand pressed hardest;
/// any other is a stroke, thinned to the places that keep it within half a cell. [one thread]
class TouchMarks {
 public:
  /// How far a finger of a person who wants to tap may slip, cells of the window: 4 mm of hand.
  static constexpr double kTapCells = 10;

  /// @param cell_mm  of the window that is touched, above 0
  std::optional<TouchMark> follow(const TouchSample& sample, double cell_mm);
  /// Forgets a contact that is under way.
  void forget() { way_.clear(); }

 private:
  std::vector<TouchSample> way_;  // Of the contact under way.
  double cell_mm_ = 0;            // The finest one during it.
};

}  // namespace relievo
