// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

namespace relievo {

/// How long a step still takes, by how fast it went so far, in seconds; nothing while there is
/// nothing to judge by: within three seconds, before a hundredth of it, and at its end.
/// @param seconds   since it was at `began_at`
/// @param began_at  0 to 1; now it is at `fraction`
inline std::optional<double> secondsLeft(double seconds, double began_at, double fraction) {
  constexpr double kSoonS = 3, kLeastShare = 0.01;
  const double done = fraction - began_at;
  if (seconds < kSoonS || !(done > kLeastShare) || !(fraction < 1)) return std::nullopt;
  return seconds * (1 - fraction) / done;
}

}  // namespace relievo
