// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/options/map_option_use.h"

#include <string>

#include "app/cli/options/look_arguments.h"

namespace relievo::batch {

void requireUseOfMapOptions(const MapArguments& a, const Surface& surface) {
  if (!surface.is_raster || a.as_recorded) return;
  const std::string scan = "a scan, for a raster keeps its cells and heights";
  requireUse("--cells", a.cells.has_value(), false, scan);
  requireUse("--spacing", a.spacing_mm.has_value(), false, scan);
  requireUse("--engine", a.engine != MapArguments{}.engine, false, scan);
  requireUse("--rule", !a.rule.empty() && a.rule != "auto", false, scan);
  requireUse("--strays", a.strays != MapArguments{}.strays, false, scan);
  requireUse("--every", a.scan.every != MapArguments{}.scan.every, false, scan);
  // What says no more than what is: millimetres, seen from above.
  const bool own_map = surface.engine == "as stored";
  const std::string another = "a scan or raster that relievo did not write";
  requireUse("--unit", !a.unit.empty() && a.unit != "mm", !own_map, another);
  requireUse("--view", !a.view.empty() && a.view != "top" && a.view != "auto", !own_map, another);
  requireUse("--turn", !a.turn.empty(), !own_map, another);
}

}  // namespace relievo::batch
