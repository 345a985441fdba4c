// SPDX-License-Identifier: BSD-3-Clause
#include <chrono>
#include <CLI/CLI.hpp>

#include "app/cli/early_input.h"
#include "app/cli/json.h"
#include "app/cli/large.h"
#include "app/cli/map_report.h"
#include "app/cli/report_text.h"
#include "app/cli/state.h"
#include "app/cli/verb.h"
#include "core/base/failure.h"
#include "core/file/output_set.h"
#include "core/io/raster/colour_raster.h"
#include "core/io/raster/raster.h"
#include "core/project/caption.h"
#include "core/session/colours/surface_colours.h"
#include "core/tiles/tile_raster.h"

namespace relievo::batch {
namespace {

struct DepthmapArguments {
  MapArguments map;
  TileArguments tiles;
  std::string out;
  bool quality = false;
};

/// MAP.tif -> MAP.count.tif
std::filesystem::path besideMap(const std::filesystem::path& map, const std::string& what) {
  std::filesystem::path file = map;
  return file.replace_extension("." + what + map.extension().string());
}

constexpr const char* kCounts = "counts";    ///< What MAP.count.tif says that it holds.
constexpr const char* kSpreads = "spreads";  ///< Likewise MAP.spread.tif.

/// MAP.count.tif and MAP.spread.tif: NaN where a cell has no point of its own.
void writeQuality(const std::filesystem::path& out, const Surface& surface, const std::string& id,
                  OutputSet& set) {
  const QualityMap& quality = surface.quality;
  DepthMap counts{.frame = surface.map.frame,
                  .heights_mm = std::vector<float>(quality.counts.begin(), quality.counts.end()),
                  .origins = std::vector<CellStatus>(quality.counts.size(), CellStatus::measured)};
  for (std::size_t i = 0; i < quality.counts.size(); ++i) {
    if (quality.counts[i] == 0) counts.origins[i] = CellStatus::outside;
  }
  MapFileOptions options{.view_from_file = surface.view_from_file,
                         .write_origins = false,
                         .unit = kPointsUnit,
                         .set = id,
                         .what = kCounts};
  writeMap(set.file(besideMap(out, "count")), counts, options);
  counts.heights_mm = quality.spreads_mm;
  options.unit = MapFileOptions{}.unit;
  options.what = kSpreads;
  writeMap(set.file(besideMap(out, "spread")), counts, options);
}

/// Those of an older map of ours go: nobody would see that they are not of this one.
void removeQuality(const std::filesystem::path& out, OutputSet& set) {
  for (const auto& [file, what] : {std::pair{besideMap(out, "count"), kCounts},
                                   std::pair{besideMap(out, "spread"), kSpreads}}) {
    const RasterFacts facts = rasterFacts(file);
    const auto said = facts.find(kContentFact);
    if (said != facts.end() && said->second == what) set.removes(file);
  }
}

void writeFiles(const DepthmapArguments& a, const Surface& surface, const GridColours& colours,
                const std::string& state) {
  MapFileOptions options{.view_from_file = surface.view_from_file, .state = state};
  options.set = setOf(surface.map, colours, options);
  OutputSet set;
  if (a.quality && !surface.quality.empty()) {
    writeQuality(a.out, surface, options.set, set);
  } else {
    removeQuality(a.out, set);
  }
  writeMapWithColours(set.file(a.out), surface.map, colours, options);
  set.commit();
}

/// How the points carry the cells, over the cells that have any; null where not known.
Json qualityJson(const Surface& surface) {
  const QualityMap& quality = surface.quality;
  std::size_t cells = 0;
  double points = 0;
  double spread = 0;
  for (std::size_t i = 0; i < quality.counts.size(); ++i) {
    if (quality.counts[i] == 0) continue;
    ++cells;
    points += quality.counts[i];
    spread += static_cast<double>(quality.spreads_mm[i]);
  }
  if (cells == 0) return nullptr;
  const auto count = static_cast<double>(cells);
  return {{"cells_with_points", cells},
          {"mean_points", points / count},
          {"mean_spread_mm", spread / count}};
}

/// Heights of the planes and exactness of the depth buffer; null from other engines.
Json depthBufferJson(const Surface& surface) {
  if (!surface.depth_buffer) return nullptr;
  const DepthBufferFormat& format = *surface.depth_buffer;
  return {{"bits", format.bits},         {"type", format.is_float ? "float" : "fixed"},
          {"near_mm", format.near_z_mm}, {"far_mm", format.far_z_mm},
          {"step_mm", format.stepMm()},  {"accuracy_mm", format.accuracyMm()}};
}

CommandResult runDepthmap(const DepthmapArguments& a, const Task& task) {
  if (areGiven(a.tiles) && a.quality) {
    throw failure<MessageId::option_quality>();
  }
  if (a.tiles.memory_mb) return runByTiles(a.map, a.tiles, a.out, task);
  EarlyInput input(a.map.file, a.out, task);
  Surface surface = loadForVerb(a.map, task);
  if (a.quality && surface.quality.empty()) {
    surface.not_done.push_back(said<MessageId::quality_of_clouds_only>());
    tell(englishText(surface.not_done.back()));
  }
  const std::string state = toJson(provenanceOfVerb(a.map, surface, input.take()), -1);
  const auto start = std::chrono::steady_clock::now();
  const GridColours own = finestColours(surface);
  writeFiles(a, surface, own, state);
  const double write_s =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();

  const GridFrame& frame = surface.map.frame;
  const HeightRange range = heightRange(surface.map);
  Json json;
  json["cells"] = {frame.size.cols, frame.size.rows};
  json["spacing_mm"] = frame.spacing_mm;
  json["engine"] = surface.engine;
  json["depth_buffer"] = depthBufferJson(surface);
  json["rule"] = surface.rule;
  json["shares"] = sharesJson(originShares(surface.map));
  json["view_from_file"] = jsonOf(surface.view_from_file);
  json["height_mm"] = {{"min", range.min_mm}, {"max", range.max_mm}};
  json["seconds"] = {{"read", surface.seconds.read},
                     {"grid", surface.seconds.grid},
                     {"fill", surface.seconds.fill},
                     {"colours", surface.seconds.colours},
                     {"write", write_s}};
  json["view"] = surface.view_name;
  json["unit"] = name(surface.unit);
  json["unit_source"] = name(surface.unit_source);
  json["raster_scale"] = scaleJson(surface.raster_scale);
  json["holes"] = holesJson(surface.holes);
  json["colour_file"] = own.colours.empty() ? Json(nullptr) : Json(colourFileOf(a.out).string());
  json["intensity_file"] =
      own.intensities.empty() ? Json(nullptr) : Json(intensityFileOf(a.out).string());
  json["quality"] = qualityJson(surface);
  json["losses"] = lossesJson(surface.losses);
  json["strays"] = straysJson(surface.strays);
  json["missing"] = surface.missing;
  json["likely_nodata"] = suspectJson(surface.suspect_height);
  json["not_done"] = sentencesJson(surface.not_done);
  return {
      .json = reportText(json),
      .lines = {a.out + ": " + std::to_string(frame.size.cols) + " x " +
                    std::to_string(frame.size.rows) + " cells of " + shortNumber(frame.spacing_mm) +
                    " mm, view " + surface.view_name + ", method " + methodName(surface.engine),
                "heights: " + shortNumber(range.min_mm) + " to " + shortNumber(range.max_mm) +
                    " mm, " + surface.rule,
                "cells: " + sharesText(originShares(surface.map)), lossesText(surface.losses)},
      .exit_code = exitCodeAfter(surface)};
}

VerbFiles filesOf(const DepthmapArguments& a) {
  VerbFiles files;
  for (const std::filesystem::path& file : filesOf(a.map, a.tiles)) files.reads(file);
  files.namesMap("--output", a.out);
  if (a.tiles.memory_mb) {
    files.writesLevels(a.out);
  } else {
    files.writesMap(a.out);
  }
  if (a.quality) {
    files.writes(besideMap(a.out, "count"));
    files.writes(besideMap(a.out, "spread"));
  }
  return files;
}

}  // namespace

Verb depthmapVerb() {
  auto arguments = std::make_shared<DepthmapArguments>();
  return {
      .name = "depthmap",
      .help = "Make the depth map z = f(x, y) of a scan and write it as a GeoTIFF",
      .declare =
          [arguments](CLI::App& verb) {
            addMapOptions(verb, arguments->map);
            addTileOptions(verb, arguments->tiles);
            verb.add_option(
                    "-o,--output", arguments->out,
                    "MAP.tif; MAP.origin.tif beside it, and MAP.colour.tif, MAP.intensity.tif if "
                    "the scan has any")
                ->required();
            verb.add_flag("--quality", arguments->quality,
                          "Also MAP.count.tif and MAP.spread.tif: points of every cell, and "
                          "their standard deviation in mm");
          },
      .files = [arguments] { return filesOf(*arguments); },
      .run = [arguments](const Task& task) { return runDepthmap(*arguments, task); }};
}

}  // namespace relievo::batch
