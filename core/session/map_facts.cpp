// SPDX-License-Identifier: BSD-3-Clause
#include "core/session/map_facts.h"

#include "core/tiles/tiled_map.h"

namespace relievo {

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
  if (!surface.tiles) return {surface.map};
  const GridFrame& frame = surface.tiles->frames().front();
  return {frame, [tiles = surface.tiles, task, frame](Cell first, GridSize size) {
            task.check();
            return MapPart(frame, first, tiles->part(Level{0}, first, size));
          }};
}

}  // namespace relievo
