// SPDX-License-Identifier: BSD-3-Clause
#include "core/session/unit_guess.h"

#include <algorithm>

namespace relievo {

LengthUnit guessedUnit(const FileBounds& bounds) {
  const FilePoint size = bounds.max - bounds.min;
  const double longest = std::max({size.x, size.y, size.z});
  constexpr double kShortestObject = 5;  // Of a scan in millimetres, about a seal stone.
  constexpr double kLongestObject =
      3000;  // Beyond, millimetres are less likely than a site in metres.
  return longest >= kShortestObject && longest <= kLongestObject ? LengthUnit::mm : LengthUnit::m;
}

}  // namespace relievo
