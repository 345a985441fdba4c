// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "haptics/proxy/patch.h"
#include "haptics/rt/realtime.h"

namespace relievo {

/// The 1, 2 or 4 closed cells that contain a point.
struct IncidentCells {
  int count = 0;
  int col[4] = {}, row[4] = {};
};

inline IncidentCells incidentCells(double x, double y) RELIEVO_REALTIME {
  const int right = cellOf(x, 1), left = cellOf(x, -1);
  const int top = cellOf(y, 1), low = cellOf(y, -1);
  IncidentCells cells;
  if (left == right && low == top) {  // The usual case: inside one cell.
    cells.count = 1;
    cells.col[0] = left;
    cells.row[0] = low;
    return cells;
  }
  for (int row = low; row <= top; ++row) {
    for (int col = left; col <= right; ++col) {
      cells.col[cells.count] = col;
      cells.row[cells.count] = row;
      ++cells.count;
    }
  }
  return cells;
}

}  // namespace relievo
