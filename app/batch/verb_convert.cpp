// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <CLI/CLI.hpp>

#include "app/batch/json.h"
#include "app/batch/look_arguments.h"
#include "app/batch/state.h"
#include "app/batch/verb.h"
#include "core/base/error.h"
#include "core/base/replaceable.h"
#include "core/io/colour_raster.h"
#include "core/io/export_grid.h"
#include "core/io/import.h"
#include "core/io/raster.h"
#include "core/project/caption.h"
#include "core/relief/relief_image.h"

namespace relievo::batch {
namespace {

struct ConvertArguments {
  MapArguments map;
  std::string out;
  std::string frame;  ///< Empty: file for rasters of others, view for all else.
  std::optional<double> plate_mm;
  LookArguments look;
};

/// A surface, and the raster it was made from, if it was.
struct Source {
  Surface surface;
  std::optional<RasterMap> raster;
};

Source load(const ConvertArguments& a, const Task& task) {
  if (!looksLikeRaster(a.map.file)) return {loadForVerb(a.map, task), std::nullopt};
  RasterMap raster = importRaster(a.map.file, {}, task);
  Source source{makeSurface(raster, surfaceOptions(a.map), task), std::move(raster)};
  for (const std::string& message : source.surface.messages) tell(message);
  for (const std::string& message : source.surface.not_done) tell(message);
  return source;
}

ExportGrid gridInFile(const Source& source, const std::string& file) {
  const Surface& surface = source.surface;
  auto grid = fileGrid(surface.map, surface.view_from_file, surface.unit,
                       source.raster ? &*source.raster : nullptr);
  if (grid) return std::move(*grid);
  throw ArgumentError("--frame file: " + file +
                      " was not seen from the top, so heights are no z of the file. Choose --view "
                      "top or --frame view.");
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
    throw ArgumentError("--relief: lit stone has no values. Choose another, or 'relievo render'.");
  }
  if (showsOwnColours(look.kind)) {
    throw ArgumentError("--relief: '" + std::string(name(look.kind)) +
                        "' has no values of the relief. Choose another, or 'relievo render'; "
                        "colours are written beside a map without --relief.");
  }
  if (format != ExportFormat::geotiff && format != ExportFormat::ascii_grid) {
    throw ArgumentError("--relief: its values go into .tif or .asc, not into '" + a.out + "'.");
  }
  return look;
}

Outcome runConvert(const ConvertArguments& a, const Task& task) {
  requireReplaceable(a.out);
  const auto format = exportFormatOf(a.out);
  if (!format) {
    throw ArgumentError(a.out + ": its ending is none of .tif, .asc, .vti, .ply, .xyz and .stl.");
  }
  if (!a.frame.empty() && a.frame != "view" && a.frame != "file") {
    throw ArgumentError("--frame: '" + a.frame + "' is neither view nor file.");
  }
  requireUse("--plate", a.plate_mm.has_value(), *format == ExportFormat::stl, "an OUT.stl");
  std::optional<ReliefLook> look;
  if (!a.look.relief.empty()) {
    look = valuesAskedFor(a, *format);
  } else if (!a.look.light.empty() || a.look.radius_mm) {
    throw ArgumentError("--light and --radius belong to --relief. Give it, or leave them out.");
  }
  const Source source = load(a, task);
  const Surface& surface = source.surface;
  const bool foreign = source.raster && !source.raster->is_own_map;
  const bool in_file =
      a.frame.empty() ? foreign && *format != ExportFormat::stl : a.frame == "file";
  Provenance provenance = provenanceOfVerb(a.map, surface, a.out, task);
  provenance.values = look;
  const std::string state = toJson(provenance, -1);
  ExportGrid grid = in_file ? gridInFile(source, a.map.file) : viewGrid(surface.map);
  const std::string unit = grid.unit;
  grid.state = state;
  const GridColours own = surface.colours.empty() ? GridColours{} : surface.colours.front();
  grid.colours = own.colours;
  if (look) {
    grid.unit = paint(grid, surface.map, *look, task);
    exportGrid(a.out, grid, *format);
  } else if (*format == ExportFormat::geotiff && !in_file) {
    writeColours(a.out, surface.map, own);
    writeMap(a.out, surface.map,
             {.view_from_file = surface.view_from_file, .mask_band = true, .state = state});
  } else {
    ExportOptions how;
    how.plate_mm = a.plate_mm.value_or(how.plate_mm);
    exportGrid(a.out, grid, *format, how);
  }

  const auto heights = static_cast<std::size_t>(
      std::count_if(grid.origins.begin(), grid.origins.end(),
                    [](Origin origin) { return origin != Origin::outside; }));
  Json json;
  json["file"] = a.out;
  json["cells"] = {grid.size.cols, grid.size.rows};
  json["spacing"] = grid.spacing;
  json["first"] = {grid.first_x, grid.first_y};
  json["unit"] = unit;
  if (look) json["relief"] = name(look->kind);
  json["frame"] = in_file ? "file" : "view";
  json["heights"] = heights;
  return {.json = json.dump(2),
          .lines = {a.out + ": " + std::to_string(grid.size.cols) + " x " +
                    std::to_string(grid.size.rows) + " cells of " + shortNumber(grid.spacing, 9) +
                    " " + unit + ", " + std::to_string(heights) +
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
  return {.name = "convert",
          .help = "Write the depth map of a file for other programs: .tif .asc .vti .ply .xyz .stl",
          .declare =
              [arguments](CLI::App& verb) {
                addMapOptions(verb, arguments->map);
                verb.add_option("OUT", arguments->out,
                                "GeoTIFF, ESRI ASCII grid, VTK image, mesh, points, or a plate to "
                                "print, by its ending")
                    ->required();
                verb.add_option("--frame", arguments->frame,
                                "view: mm above the base plane; file: the file's coordinates and "
                                "unit (the default for rasters)");
                verb.add_option("--plate", arguments->plate_mm,
                                "STL: thickness below the lowest height in mm; 3");
                addValueOptions(verb, arguments->look);
              },
          .files = [arguments] { return filesOf(*arguments); },
          .run = [arguments](const Task& task) { return runConvert(*arguments, task); }};
}

}  // namespace relievo::batch
