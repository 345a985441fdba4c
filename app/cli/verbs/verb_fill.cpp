// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <CLI/CLI.hpp>
#include <cmath>
#include <limits>

#include "app/cli/json.h"
#include "app/cli/map_report.h"
#include "app/cli/report_text.h"
#include "app/cli/verb.h"
#include "core/depth/colours/colour_fill.h"
#include "core/depth/colours/colours.h"
#include "core/depth/fill/fill.h"
#include "core/io/raster/colour_raster.h"
#include "core/io/raster/raster.h"
#include "core/session/colours/surface_colours.h"

namespace relievo::batch {
namespace {

struct FillArguments {
  MapArguments map;
  std::string out;
};

/// The map with its enclosed holes treated as chosen; every other cell stays as it is.
FilledMap refilled(const DepthMap& map, const HoleChoice& choice, const Task& task) {
  FrontDepths depths(map.heights_mm.size(), std::numeric_limits<float>::quiet_NaN());
  for (std::size_t i = 0; i < depths.size(); ++i) {
    const bool hole =
        map.origins[i] == CellStatus::base_plane || map.origins[i] == CellStatus::outside;
    if (!hole) depths[i] = map.heights_mm[i];
  }
  FilledMap filled =
      fillDepths(depths, map.frame, {.has_sampling_gaps = false, .base_quantile = 0}, choice, task);
  for (std::size_t i = 0; i < depths.size(); ++i) {
    CellStatus& origin = filled.map.origins[i];
    float& height = filled.map.heights_mm[i];
    if (!std::isnan(depths[i])) {
      origin = map.origins[i];
      height = map.heights_mm[i];
    } else if (origin == CellStatus::interpolated) {
      height += static_cast<float>(filled.base_z_mm);  // Back to the map's own base plane.
    } else {
      height = 0;
    }
  }
  return filled;
}

CommandResult runFill(const FillArguments& a, const Task& task) {
  const HoleChoice choice = surfaceOptions(a.map).holes;
  MapArguments as_it_is = a.map;
  as_it_is.holes = "base";
  const Surface surface = loadForVerb(as_it_is, task);
  const FilledMap filled = refilled(surface.map, choice, task);
  GridColours own = finestColours(surface);
  fillColours(own, filled.map, task);
  writeMapWithColours(a.out, filled.map, own, {.view_from_file = surface.view_from_file});

  CommandResult outcome;
  if (const auto missing = holesLeft(filled.holes, choice)) {
    tell(englishText(*missing));
    outcome.exit_code = 4;
  }
  if (filled.holes.empty()) tell("The map has no enclosed holes; nothing was filled.");
  const auto done = std::count_if(filled.holes.begin(), filled.holes.end(),
                                  [](const Hole& h) { return h.filled; });
  outcome.json =
      reportText(Json{{"file", a.out}, {"holes", holesJson(filled.holes)}, {"filled", done}});
  outcome.lines = {a.out + ": " + std::to_string(done) + " of " +
                   std::to_string(filled.holes.size()) + " holes filled"};
  return outcome;
}

VerbFiles filesOf(const FillArguments& a) {
  VerbFiles files;
  files.reads(a.map.file);
  files.writesMap(a.out);
  files.namesMap("--output", a.out);
  return files;
}

}  // namespace

Verb fillVerb() {
  auto arguments = std::make_shared<FillArguments>();
  return {.name = "fill",
          .help = "Treat the enclosed holes of a map anew; all other cells stay",
          .declare =
              [arguments](CLI::App& verb) {
                addMapOptions(verb, arguments->map);
                verb.add_option("-o,--output", arguments->out, "MAP.tif; MAP.origin.tif beside it")
                    ->required();
              },
          .files = [arguments] { return filesOf(*arguments); },
          .run = [arguments](const Task& task) { return runFill(*arguments, task); }};
}

}  // namespace relievo::batch
