// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/options/map_option_use.h"

#include <string>

#include "app/cli/options/look_arguments.h"
#include "app/cli/verb.h"
#include "core/message/catalogue.h"
#include "core/session/large/large_map.h"

namespace relievo::batch {
namespace {

void tellUnused(const char* option, bool given, const Message& why) {
  if (given) tell(englishText(said<MessageId::option_changes_nothing>(option, why)));
}

/// @param is_own  relievo wrote the raster
void tellUnusedOfRaster(const MapArguments& a, bool is_own) {
  const MapArguments none;
  const Message kept = said<MessageId::raster_keeps_cells>();
  tellUnused("--cells", a.cells.has_value(), kept);
  tellUnused("--spacing", a.spacing_mm.has_value(), kept);
  tellUnused("--engine", a.engine != none.engine, kept);
  tellUnused("--rule", !a.rule.empty() && a.rule != "auto", kept);
  tellUnused("--strays", a.strays != none.strays, kept);
  tellUnusedScanOptions(a.scan);
  if (!is_own) return;
  // What says no more than what is: millimetres, seen from above.
  const Message own = said<MessageId::raster_taken_as_is>();
  tellUnused("--unit", !a.unit.empty() && a.unit != "mm", own);
  tellUnused("--view", !a.view.empty() && a.view != "top" && a.view != "auto", own);
  tellUnused("--turn", !a.turn.empty(), own);
}

}  // namespace

void tellUnusedMapOptions(const MapArguments& a, const Surface& surface) {
  if (!surface.is_raster || a.as_recorded) return;
  tellUnusedOfRaster(a, surface.engine == "as stored");
}

void tellUnusedMapOptions(const MapArguments& a, const LargeMap& map) {
  const bool is_own = map.engine == "as stored";
  if (is_own || map.engine == "raster") tellUnusedOfRaster(a, is_own);
}

void tellUnusedScanOptions(const ScanArguments& a) {
  const Message points = said<MessageId::raster_without_points>();
  tellUnused("--reader", a.reader != ScanArguments{}.reader, points);
  tellUnused("--parts", !a.parts.empty(), points);
  tellUnused("--keep-withheld", a.keep_withheld, points);
  tellUnused("--load-incomplete", a.accept_incomplete, points);
  tellUnused("--every", a.every != ScanArguments{}.every, said<MessageId::raster_keeps_cells>());
}

void requireRasterUse(const SurfaceOptions& options, const Surface& surface) {
  const bool has_scale = surface.raster_scale.has_value();
  const std::string raster = englishText(said<MessageId::raster_of_others>());
  requireUse("--pixel-size", options.raster.pixel_mm.has_value(), has_scale, raster);
  requireUse("--height-scale", options.raster.height_mm.has_value(), has_scale, raster);
  requireUse("--height-zero", options.raster.zero.has_value(), has_scale, raster);
}

}  // namespace relievo::batch
