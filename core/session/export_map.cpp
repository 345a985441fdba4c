// SPDX-License-Identifier: BSD-3-Clause
#include "core/session/export_map.h"

#include <algorithm>
#include <utility>

#include "core/base/failure.h"
#include "core/io/raster/colour_raster.h"
#include "core/io/raster/raster.h"
#include "core/region/window.h"
#include "core/session/colours/surface_colours.h"
#include "core/session/large/crop_level.h"
#include "core/session/large/memory_guard.h"
#include "core/session/large/tiled_surface.h"

namespace relievo {
namespace {

Level levelOf(const MapExport& choice) {
  return choice.part == ExportPart::level ? choice.region.level : Level{0};
}

DepthMap partOf(const Surface& surface, const MapExport& choice) {
  if (choice.part == ExportPart::window) return windowMap(windowOf(surface, choice.region));
  const Level level = levelOf(choice);
  if (level.value == 0 && !surface.tiles) return surface.map;
  if (surface.tiles) requireMemory(levelFrame(surface, level), availableBytes());
  return cropLevel(surface, level);
}

/// Of the same samples; empty where the scan has none. Samples without one are mid grey.
std::vector<Rgba> coloursOf(const Surface& surface, const MapExport& choice) {
  constexpr Rgba kMidGrey{128, 128, 128, 255};
  GridColours own = choice.part == ExportPart::window
                        ? windowColours(surface, windowOf(surface, choice.region))
                        : levelColours(surface, levelOf(choice));
  for (Rgba& colour : own.colours) {
    colour = colour[3] == 0 ? kMidGrey : Rgba{colour[0], colour[1], colour[2], 255};
  }
  return std::move(own.colours);
}

}  // namespace

GridSize exportedSize(const Surface& surface, const MapExport& choice) {
  if (choice.part == ExportPart::window) return {.cols = kWindowSamples, .rows = kWindowSamples};
  return levelFrame(surface, levelOf(choice)).size;
}

ExportGrid exportedGrid(const Surface& surface, const MapExport& choice, const RasterMap* raster) {
  const DepthMap map = partOf(surface, choice);
  if (!choice.in_file_frame) {
    ExportGrid grid = viewGrid(map);
    grid.state = choice.state;
    grid.colours = coloursOf(surface, choice);
    return grid;
  }
  auto grid = fileGrid(map, surface.view_from_file, surface.unit, raster);
  if (!grid) {
    throw failure<MessageId::heights_not_from_the_top>(surface.info.file.filename());
  }
  if (raster == nullptr) stateSystem(*grid, surface.info.reference_system, surface.unit);
  grid->state = choice.state;
  grid->colours = coloursOf(surface, choice);
  return std::move(*grid);
}

ExportedMap reportOf(const ExportGrid& grid) {
  const auto empty = std::count(grid.origins.begin(), grid.origins.end(), CellStatus::outside);
  return {.size = grid.size,
          .spacing = grid.spacing,
          .first_x = grid.first_x,
          .first_y = grid.first_y,
          .unit = grid.unit,
          .heights = grid.origins.size() - static_cast<std::size_t>(empty),
          .left_out = grid.left_out};
}

ExportedMap exportMap(const std::filesystem::path& file, const Surface& surface,
                      const MapExport& choice, const RasterMap* raster, const Task& task) {
  task.check();
  const ExportGrid grid = exportedGrid(surface, choice, raster);
  const bool is_map = choice.format == ExportFormat::geotiff && !choice.in_file_frame &&
                      choice.part == ExportPart::map && !surface.tiles;
  if (is_map) {
    writeMapWithColours(
        file, surface.map, finestColours(surface),
        {.view_from_file = surface.view_from_file, .mask_band = true, .state = choice.state});
  } else {
    exportGrid(file, grid, choice.format, {.plate_mm = choice.plate_mm}, task);
  }
  return reportOf(grid);
}

}  // namespace relievo
