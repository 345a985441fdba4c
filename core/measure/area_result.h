// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "core/measure/measure.h"
#include "core/message/message.h"

namespace relievo {

/// A piece of surface inside a closed outline. Outside cells do not count. What each may be off:
/// docs/adr/0078.
struct AreaResult {
  double area_mm2 = 0, area_off_mm2 = 0;        ///< Seen along the view.
  double surface_mm2 = 0, surface_off_mm2 = 0;  ///< Of the relief itself, by its slopes.
  double volume_mm3 = 0, volume_off_mm3 = 0;    ///< Above the plane; what lies below counts 0.
  double not_measured = 0;                      ///< Share of its cells.
};

/// Why an outline encloses nothing that could be measured; nothing: it does.
std::optional<Message> outlineRefusal(const std::vector<PlaceMm>& outline);

/// Counts each cell by the share of its 4 x 4 points that lie inside the outline (even-odd).
/// Reads the rows that the outline spans, some at a time.
AreaResult areaResultOf(const MapCells& map, const std::vector<PlaceMm>& outline, double plane_mm);

}  // namespace relievo
