// SPDX-License-Identifier: BSD-3-Clause
#include "core/session/large/tiled_surface.h"

#include <algorithm>

#include "core/message/catalogue.h"
#include "core/tiles/tiled_map.h"

namespace relievo {

Surface openTiledSurface(const std::filesystem::path& finest, std::size_t cache_bytes,
                         const Task& task) {
  constexpr int kMostAcross = 1024;
  auto tiles = std::make_shared<const TiledMap>(finest, cache_bytes, task);
  Surface surface;
  surface.is_raster = true;
  surface.unit = LengthUnit::mm;
  surface.unit_source = UnitSource::file;
  surface.view_from_file = tiles->viewFromFile();
  surface.view_name = surface.engine = surface.rule = "as stored";
  surface.ladder = tiles->ladder();
  const std::vector<GridFrame>& frames = tiles->frames();
  const auto shown = std::find_if(frames.begin(), frames.end() - 1, [](const GridFrame& frame) {
    return std::max(frame.size.cols, frame.size.rows) <= kMostAcross;
  });
  surface.map = tiles->levelMap({static_cast<int>(shown - frames.begin())});
  const GridSize size = frames.front().size;
  surface.info.file = finest;
  surface.info.format = (tiles->published() ? "published map, " : "GeoTIFF tiles, ") +
                        std::to_string(frames.size()) + " levels";
  surface.info.points = surface.info.finite_points = size.count();
  surface.info.unit = LengthUnit::mm;
  if (const std::optional<Message>& left = tiles->coloursLeftAside()) {
    surface.messages.push_back(said<MessageId::colours_left_aside>(*left));
  }
  surface.tiles = std::move(tiles);
  return surface;
}

RegionWindow windowOf(const Surface& surface, const Region& region, double gain) {
  return surface.tiles ? surface.tiles->window(region, gain)
                       : sampleWindow(surface.map, surface.pyramid, region, gain);
}

}  // namespace relievo
