// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>

#include "app/cli/early_input.h"
#include "app/cli/json.h"
#include "app/cli/large.h"
#include "app/cli/report_text.h"
#include "app/cli/state.h"
#include "app/cli/verb.h"
#include "core/file/output_set.h"
#include "core/io/raster/colour_raster.h"
#include "core/io/raster/raster.h"
#include "core/io/raster/tiff_head.h"
#include "core/region/smoothing.h"
#include "core/tiles/level_files.h"

namespace relievo::batch {
namespace {

struct PyramidArguments {
  MapArguments map;
  TileArguments tiles;
  std::string out;
};

/// OUT.tif -> OUT.L<level>.tif
std::filesystem::path levelFile(const std::filesystem::path& out, std::size_t level) {
  std::filesystem::path file = out;
  file.replace_extension(".L" + std::to_string(level) + out.extension().string());
  return file;
}

DepthMap mapOf(const PyramidLevel& level) {
  return {.frame = level.frame,
          .heights_mm = {level.heights_mm.begin(), level.heights_mm.end()},
          .origins = std::vector<CellStatus>(level.heights_mm.size(), CellStatus::measured)};
}

GridColours coloursOf(const Surface& surface, std::size_t level) {
  return surface.colours.empty() ? GridColours{} : surface.colours[level].all();
}

/// All levels take their places together, the finest last; levels of an older pyramid that went
/// further go.
void writeLevels(const std::filesystem::path& out, const Surface& surface,
                 const std::string& state) {
  MapFileOptions options{
      .view_from_file = surface.view_from_file, .write_origins = false, .state = state};
  options.set = setOf(surface.map, coloursOf(surface, 0), options);
  const std::size_t count = surface.pyramid.levels.size();
  OutputSet set;
  for (std::size_t l = count; l-- > 0;) {
    options.level = static_cast<int>(l);
    writeMapWithColours(set.file(levelFile(out, l)), mapOf(surface.pyramid.levels[l]),
                        coloursOf(surface, l), options);
  }
  removeLevelsFrom(levelFile(out, 0), static_cast<int>(count), set);
  set.commit();
}

CommandResult runPyramid(const PyramidArguments& a, const Task& task) {
  requireOwnOrAbsent(levelFile(a.out, 0));
  if (areGiven(a.tiles)) return runByTiles(a.map, a.tiles, levelFile(a.out, 0), task);
  EarlyInput input(a.map.file, a.out, task);
  const Surface surface = loadForVerb(a.map, task);
  for (std::size_t l = 0; l < surface.pyramid.levels.size(); ++l) {
    requireOwnOrAbsent(levelFile(a.out, l));
  }
  const std::string state = toJson(provenanceOfVerb(a.map, surface, input.take()), -1);
  writeLevels(a.out, surface, state);
  Json levels = Json::array();
  CommandResult outcome;
  for (std::size_t l = 0; l < surface.pyramid.levels.size(); ++l) {
    const PyramidLevel& level = surface.pyramid.levels[l];
    const std::filesystem::path file = levelFile(a.out, l);
    levels.push_back({{"level", l},
                      {"cells", {level.frame.size.cols, level.frame.size.rows}},
                      {"spacing_mm", level.frame.spacing_mm},
                      {"sigma_mm", smoothingMm(surface.ladder, {static_cast<int>(l)})},
                      {"file", file.string()}});
    outcome.lines.push_back(file.string() + ": " + std::to_string(level.frame.size.cols) + " x " +
                            std::to_string(level.frame.size.rows));
  }
  const double factor = surface.pyramid.factor;
  outcome.json = reportText(
      {{"levels", levels}, {"factor", factor}, {"gain_at_nyquist", gainAtNyquist(factor)}});
  outcome.exit_code = exitCodeAfter(surface);
  return outcome;
}

VerbFiles filesOf(const PyramidArguments& a) {
  VerbFiles files;
  for (const std::filesystem::path& file : filesOf(a.map, a.tiles)) files.reads(file);
  // A name without an ending is the beginning of the levels' names, which then have none either.
  if (std::filesystem::path(a.out).has_extension()) files.namesMap("--output", a.out);
  files.writesLevels(levelFile(a.out, 0));
  return files;
}

}  // namespace

Verb pyramidVerb() {
  auto arguments = std::make_shared<PyramidArguments>();
  return {.name = "pyramid",
          .help = "Write every level of the Gaussian pyramid, one GeoTIFF each",
          .declare =
              [arguments](CLI::App& verb) {
                addMapOptions(verb, arguments->map);
                addTileOptions(verb, arguments->tiles);
                verb.add_option("-o,--output", arguments->out, "OUT.tif becomes OUT.L0.tif, ...")
                    ->required();
              },
          .files = [arguments] { return filesOf(*arguments); },
          .run = [arguments](const Task& task) { return runPyramid(*arguments, task); }};
}

}  // namespace relievo::batch
