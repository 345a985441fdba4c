// SPDX-License-Identifier: BSD-3-Clause
#include "core/outline/two_groups.h"

#include <cstddef>

namespace relievo {

TwoGroups partedInTwo(std::span<const float> ascending) {
  TwoGroups groups;
  if (ascending.empty()) return groups;
  const auto n = static_cast<double>(ascending.size());
  double sum = 0, squares = 0;
  const double zero = ascending.front();  // So that no digits are lost high above the base plane.
  for (const float h : ascending) {
    sum += h - zero;
    squares += (h - zero) * (h - zero);
  }
  const double variance = squares / n - sum / n * (sum / n);
  if (variance <= 0) return groups;
  double below = 0, best = 0;
  for (std::size_t i = 0; i + 1 < ascending.size(); ++i) {
    below += ascending[i] - zero;
    if (ascending[i] == ascending[i + 1]) continue;
    const double n_below = static_cast<double>(i + 1), n_above = n - n_below;
    const double apart = below / n_below - (sum - below) / n_above;
    const double between = n_below * n_above / (n * n) * apart * apart;
    if (between <= best) continue;
    best = between;
    groups.threshold_mm = 0.5 * (static_cast<double>(ascending[i]) + ascending[i + 1]);
  }
  groups.separability = best / variance;
  return groups;
}

}  // namespace relievo
