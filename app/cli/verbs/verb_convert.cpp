// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>

#include "app/cli/json.h"
#include "app/cli/options/look_arguments.h"
#include "app/cli/options/map_option_use.h"
#include "app/cli/options/number_option.h"
#include "app/cli/report_text.h"
#include "app/cli/state.h"
#include "app/cli/verb.h"
#include "core/base/failure.h"
#include "core/base/replaceable.h"
#include "core/io/raster/raster.h"
#include "core/project/caption.h"
#include "core/relief/relief_image.h"
#include "core/session/export_map.h"
#include "core/session/open_input.h"

namespace relievo::batch {
namespace {

struct ConvertArguments {
  MapArguments map;
  std::string out;
  std::string frame;  ///< Empty: file for rasters of others, view for all else.
  std::optional<double> plate_mm;
  bool cloud = false;
  std::optional<int> level;
  std::string region;
  LookArguments look;
};

/// A surface, and the raster it was made from, if it was.
struct Source {
  Surface surface;
  std::optional<RasterMap> raster;
};

Source load(const ConvertArguments& a, const Task& task) {
  const InputFacts facts = inputFacts(a.map.file, task);
  if (facts.kind == InputKind::scan) return {loadForVerb(a.map, task), std::nullopt};
  RasterMap raster =
      *openInput(a.map.file, {.import = {}, .by_tiles = false, .facts = facts}, task).raster;
  const SurfaceOptions options = surfaceOptions(a.map);
  Source source{makeSurface(raster, options, task), std::move(raster)};
  requireRasterUse(options, source.surface);
  for (const Message& message : source.surface.messages) tell(englishText(message));
  for (const Message& message : source.surface.not_done) tell(englishText(message));
  tellUnusedMapOptions(a.map, source.surface);
  return source;
}

/// The values of a relief image in place of the heights. @return their unit
std::string paint(ExportGrid& grid, const DepthMap& map, const ReliefLook& look, const Task& task) {
  ReliefValues values = reliefValues(map, look, task);
  grid.heights = std::move(values.values);
  return std::string(values.unit);
}

ReliefLook valuesAskedFor(const ConvertArguments& a, ExportFormat format) {
  const ReliefLook look = reliefLook(a.look);
  if (look.kind == ReliefKind::lit) {
    throw failure<MessageId::convert_lit_stone>();
  }
  if (showsOwnColours(look.kind)) {
    throw failure<MessageId::convert_no_values>(name(look.kind));
  }
  if (format != ExportFormat::geotiff && format != ExportFormat::ascii_grid) {
    throw failure<MessageId::convert_values_name>(a.out);
  }
  return look;
}

/// The whole map, a level of it, or the samples of a window.
MapExport partAskedFor(const ConvertArguments& a, const Surface& surface) {
  MapExport choice;
  if (!a.look.relief.empty() && (a.level || !a.region.empty())) {
    throw failure<MessageId::convert_whole_map>();
  }
  if (a.level || !a.region.empty()) {
    RegionArguments region;
    region.level = a.level;
    region.region = a.region;
    choice.region = chosenRegion(surface, region);
    choice.part = a.region.empty() ? ExportPart::level : ExportPart::window;
  }
  return choice;
}

CommandResult runConvert(const ConvertArguments& a, const Task& task) {
  requireReplaceable(a.out);
  auto format = exportFormatOf(a.out);
  if (!format) {
    throw failure<MessageId::convert_name>(a.out);
  }
  requireUse("--cog", a.cloud, *format == ExportFormat::geotiff, "an OUT.tif");
  if (a.cloud) format = ExportFormat::cloud_geotiff;
  if (!a.frame.empty() && a.frame != "view" && a.frame != "file") {
    throw failure<MessageId::option_neither>("--frame", a.frame, "view", "file");
  }
  requireUse("--plate", a.plate_mm.has_value(), *format == ExportFormat::stl, "an OUT.stl");
  std::optional<ReliefLook> look;
  if (!a.look.relief.empty()) {
    look = valuesAskedFor(a, *format);
  } else if (!a.look.light.empty() || a.look.radius_mm) {
    throw failure<MessageId::convert_light>();
  }
  const Source source = load(a, task);
  const Surface& surface = source.surface;
  const bool foreign = source.raster && !source.raster->is_own_map;
  const bool for_eyes = *format == ExportFormat::stl || *format == ExportFormat::gltf;
  const bool in_file = a.frame.empty() ? foreign && !for_eyes : a.frame == "file";
  Provenance provenance = provenanceOfVerb(a.map, surface, a.out, task);
  provenance.values = look;
  MapExport choice = partAskedFor(a, surface);
  choice.format = *format;
  choice.in_file_frame = in_file;
  choice.plate_mm = a.plate_mm.value_or(choice.plate_mm);
  choice.state = toJson(provenance, -1);
  const RasterMap* const raster = source.raster ? &*source.raster : nullptr;
  ExportedMap written;
  if (look) {
    ExportGrid grid = exportedGrid(surface, choice, raster);
    written = reportOf(grid);
    grid.unit = paint(grid, surface.map, *look, task);
    exportGrid(a.out, grid, *format, {}, task);
  } else {
    written = exportMap(a.out, surface, choice, raster, task);
  }
  for (const std::string& words : written.left_out) tell(words);
  Json json;
  json["file"] = a.out;
  json["cells"] = {written.size.cols, written.size.rows};
  json["spacing"] = written.spacing;
  json["first"] = {written.first_x, written.first_y};
  json["unit"] = written.unit;
  if (look) json["relief"] = name(look->kind);
  json["frame"] = in_file ? "file" : "view";
  json["heights"] = written.heights;
  return {
      .json = reportText(json),
      .lines = {a.out + ": " + std::to_string(written.size.cols) + " x " +
                std::to_string(written.size.rows) + " cells of " + shortNumber(written.spacing, 9) +
                " " + written.unit + ", " + std::to_string(written.heights) +
                (look ? " with a value, frame " : " with a height, frame ") +
                json["frame"].get<std::string>()},
      .exit_code = exitCodeAfter(surface)};
}

VerbFiles filesOf(const ConvertArguments& a) {
  VerbFiles files;
  files.reads(a.map.file);
  files.writes(a.out);
  if (exportFormatOf(a.out) == ExportFormat::geotiff) files.writesColoursOf(a.out);
  return files;
}

}  // namespace

Verb convertVerb() {
  auto arguments = std::make_shared<ConvertArguments>();
  return {
      .name = "convert",
      .help =
          "Write the depth map of a file for other programs: .tif .asc .vti .ply .xyz .stl .glb",
      .declare =
          [arguments](CLI::App& verb) {
            addMapOptions(verb, arguments->map);
            verb.add_option("OUT", arguments->out,
                            "GeoTIFF, ESRI ASCII grid, VTK image, mesh (PLY, glTF), points, or a "
                            "plate to print, by its ending")
                ->required();
            verb.add_option("--frame", arguments->frame,
                            "view: mm above the base plane; file: the file's coordinates and "
                            "unit (the default for rasters)");
            verb.add_flag("--cog", arguments->cloud,
                          "OUT.tif as cloud-optimised GeoTIFF: compressed, with overviews");
            takes(verb.add_option("--level", arguments->level,
                                  "Only this level of the pyramid, 0 the finest"),
                  {.low = 0, .high = 63});
            takesList(
                verb.add_option("--region", arguments->region,
                                "Only the 200 x 200 samples of this window: X,Y,W,H in view mm"),
                4, {.low = -kFarMm, .high = kFarMm, .unit = "mm"});
            takes(verb.add_option("--plate", arguments->plate_mm,
                                  "STL: thickness below the lowest height in mm; 3"),
                  {.low = 0.01, .high = 1e4, .unit = "mm"});
            addValueOptions(verb, arguments->look);
          },
      .files = [arguments] { return filesOf(*arguments); },
      .run = [arguments](const Task& task) { return runConvert(*arguments, task); }};
}

}  // namespace relievo::batch
