// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/base/grid.h"
#include "core/base/transform.h"
#include "core/session/large/large_map.h"
#include "core/session/surface.h"
#include "core/tiles/points/scatter.h"

namespace relievo {

/// What there is of a map by tiles while its heights are made, row of tiles by row of tiles: every
/// n-th cell of them. [worker]
class ReadyRows {
 public:
  /// @param whole  of the finest level @param most_cells  across and up of what is shown, at least
  /// 1
  ReadyRows(const GridFrame& whole, int most_cells);

  /// Until their rows are ready cells have what the sample has there: heights above
  /// `lowest_mm`, the lowest place along the view. A sample that is seen from elsewhere is passed
  /// over. @param view  of the whole; its z is not looked at
  void beginWith(const Surface& sample, const ViewFromFile& view, double lowest_mm);
  /// Depths that are finished, from the lowest row on.
  void add(const DepthRows& rows);

  const ReadyMap& now() const { return ready_; }

 private:
  int whole_cols_;
  int step_;  ///< Cells of the whole, from one that is shown to the next.
  ReadyMap ready_;
};

}  // namespace relievo
