// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string>

#include "core/prepare/recipe.h"

namespace relievo::align {

struct PickedFit {
  Pose pose;         ///< Reference from scan.
  double error = 0;  ///< Root mean square of what is left; file units.
};

/// The turn and shift that bring the picks of one scan nearest to those of the reference.
/// @param scan  its name @throw ArgumentError  fewer than three pairs; no triangle of them whose
/// angles are all 5 degrees or more; or on scans of different size. The sentence names the scan
PickedFit fitPicks(std::span<const PickedPair> picks, const std::string& scan);

}  // namespace relievo::align
