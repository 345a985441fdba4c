// SPDX-License-Identifier: BSD-3-Clause
#include "core/session/map_facts.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/depth/rules/point_rule.h"
#include "core/tiles/tiled_map.h"

namespace relievo {
namespace {

/// Rules that take one of a cell's points for its height, by their words in Surface::rule.
bool takesOnePoint(const std::string& rule) {
  constexpr std::array kOfOnePoint{PointRule::front, PointRule::second, PointRule::lowest};
  return std::any_of(kOfOnePoint.begin(), kOfOnePoint.end(),
                     [&rule](PointRule of) { return rule.ends_with(describe(of)); });
}

/// Of 1 in the file's heights.
double stepMm(const Surface& surface) {
  return surface.raster_scale ? std::abs(surface.raster_scale->height_mm) : mmPer(surface.unit);
}

HeightErrors heightErrors(const Surface& surface) {
  HeightErrors errors;
  errors.step_mm = surface.depth_buffer ? 2 * surface.depth_buffer->accuracyMm()
                                        : surface.info.height_step * stepMm(surface);
  if (!surface.quality.empty()) errors.quality = &surface.quality;
  errors.of_one_point = takesOnePoint(surface.rule);
  return errors;
}

}  // namespace

const GridFrame& mapFrame(const Surface& surface) {
  return surface.tiles ? surface.tiles->frames().front() : surface.map.frame;
}

MapFacts mapFacts(const Surface& surface) {
  if (surface.tiles) {
    return {.heights = surface.tiles->heights(), .shares = surface.tiles->shares()};
  }
  return {.heights = heightRange(surface.map), .shares = originShares(surface.map)};
}

MapCells mapCells(const Surface& surface, const Task& task) {
  if (!surface.tiles) return {surface.map, heightErrors(surface)};
  const GridFrame& frame = surface.tiles->frames().front();
  return {frame, [tiles = surface.tiles, task, frame](Cell first, GridSize size) {
            task.check();
            return MapPart(frame, first, tiles->part(Level{0}, first, size));
          }};
}

}  // namespace relievo
