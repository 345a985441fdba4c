// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/options/map_option_use.h"

#include <string>

#include "app/cli/verb.h"

namespace relievo::batch {

void tellUnusedMapOptions(const MapArguments& a, const Surface& surface) {
  if (!surface.is_raster || a.as_recorded) return;
  const auto tellUnused = [](const std::string& option, bool given, const std::string& why) {
    if (given) tell(option + " changes nothing here: " + why);
  };
  const std::string raster = "a raster keeps its cells and heights.";
  tellUnused("--cells", a.cells.has_value(), raster);
  tellUnused("--spacing", a.spacing_mm.has_value(), raster);
  tellUnused("--engine", a.engine != MapArguments{}.engine, raster);
  tellUnused("--rule", !a.rule.empty() && a.rule != "auto", raster);
  tellUnused("--strays", a.strays != MapArguments{}.strays, raster);
  tellUnused("--every", a.scan.every != MapArguments{}.scan.every, raster);
  if (surface.engine != "as stored") return;
  // What says no more than what is: millimetres, seen from above.
  const std::string own = "a map that relievo wrote is taken as it is.";
  tellUnused("--unit", !a.unit.empty() && a.unit != "mm", own);
  tellUnused("--view", !a.view.empty() && a.view != "top" && a.view != "auto", own);
  tellUnused("--turn", !a.turn.empty(), own);
}

}  // namespace relievo::batch
