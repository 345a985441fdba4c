// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/message/message.h"
#include "core/prepare/recipe.h"

namespace relievo::align {

struct PickedFit {
  Pose pose;                   ///< Reference from scan.
  double error = 0;            ///< Root mean square of `errors`; file units.
  std::vector<double> errors;  ///< Of each pair: how far apart its places are left; file units.
};

/// Why no pose can be made of these pairs, in a sentence that names the scan: fewer than three; no
/// triangle of them whose angles are all 5 degrees or more; scans of different size. Nothing: it
/// can. [any thread]
std::optional<Message> pickProblem(std::span<const PickedPair> picks, const std::string& scan);

/// The turn and shift that bring the picks of one scan nearest to those of the reference.
/// [any thread] @param scan  its name @throw ArgumentError  pickProblem()
PickedFit fitPicks(std::span<const PickedPair> picks, const std::string& scan);

}  // namespace relievo::align
