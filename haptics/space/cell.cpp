// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/space/cell.h"

namespace relievo {

Corners brokenCorners(const HapticSpace& space, int col, int row) RELIEVO_REALTIME {
  Corners c{smoothCorner(space, col, row), smoothCorner(space, col + 1, row),
            smoothCorner(space, col, row + 1), smoothCorner(space, col + 1, row + 1)};
  std::array<bool, 4> break_x{}, break_y{};
  for (std::size_t i = 0; i < 4; ++i) {
    const int at_col = col + static_cast<int>(i % 2), at_row = row + static_cast<int>(i / 2);
    const std::uint8_t mark = space.marks[HapticSpace::index(at_col, at_row)];
    break_x[i] = (mark & kBreakX) != 0;
    break_y[i] = (mark & kBreakY) != 0;
  }
  // Slopes along the four edges.
  for (const std::size_t low : {0U, 2U}) {
    const EdgeSlopes e = edgeSlopes(c[low + 1].f - c[low].f, {c[low].fx, c[low + 1].fx},
                                    break_x[low], break_x[low + 1]);
    c[low].fx = e.first;
    c[low + 1].fx = e.last;
  }
  for (const std::size_t left : {0U, 1U}) {
    const EdgeSlopes e = edgeSlopes(c[left + 2].f - c[left].f, {c[left].fy, c[left + 2].fy},
                                    break_y[left], break_y[left + 2]);
    c[left].fy = e.first;
    c[left + 2].fy = e.last;
  }
  // Twists: a corner that breaks in one direction follows that direction's edge, with the same
  // rule; one that breaks in both takes the twist of straight lines.
  const Corners edges = c;
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t beside = i ^ 1U, across = i ^ 2U;
    const double sign_x = i % 2 == 0 ? 1 : -1, sign_y = i / 2 == 0 ? 1 : -1;
    const double along_x = sign_x * (edges[beside].fy - edges[i].fy);
    const double along_y = sign_y * (edges[across].fx - edges[i].fx);
    if (break_x[i] && break_y[i]) {
      c[i].fxy = 0.5 * (along_x + along_y);
    } else if (break_x[i]) {
      const bool straight = break_x[beside] || break_y[beside];
      c[i].fxy = straight ? along_x : 2 * along_x - edges[beside].fxy;
    } else if (break_y[i]) {
      const bool straight = break_y[across] || break_x[across];
      c[i].fxy = straight ? along_y : 2 * along_y - edges[across].fxy;
    }
  }
  return c;
}

}  // namespace relievo
