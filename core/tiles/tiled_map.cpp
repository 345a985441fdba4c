// SPDX-License-Identifier: BSD-3-Clause
#include "core/tiles/tiled_map.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <utility>

#include "core/base/failure.h"
#include "core/base/threads.h"
#include "core/io/input_facts.h"
#include "core/region/window_colours.h"
#include "core/tiles/map/fetched_rows.h"
#include "core/tiles/map/map_files.h"
#include "core/tiles/map/tiled_facts.h"
#include "core/tiles/published/published_tiles.h"
#include "core/tiles/tile_cache.h"
#include "core/tiles/tile_layout.h"

namespace relievo {
namespace {

/// Heights of the finest level are NaN outside the object, where a window has 0.
void checkHeights(std::span<std::byte> bytes, bool nan_is_outside,
                  const std::filesystem::path& file) {
  auto* heights = reinterpret_cast<float*>(bytes.data());
  for (std::size_t i = 0; i < bytes.size() / sizeof(float); ++i) {
    if (std::isfinite(heights[i])) continue;
    if (!nan_is_outside || !std::isnan(heights[i]))
      refuseMap(file, said<MessageId::tiles_height_not_finite>());
    heights[i] = 0;
  }
}

void checkOrigins(std::span<const std::byte> bytes, const std::filesystem::path& file) {
  const auto most = static_cast<std::byte>(kOriginCount - 1);
  if (*std::max_element(bytes.begin(), bytes.end()) > most) {
    refuseMap(file, said<MessageId::tiles_no_origin>());
  }
}

}  // namespace

struct TiledMap::Impl {
  Impl(const std::filesystem::path& finest, std::size_t cache_bytes, const Task& task);
  void takePublished();
  void pinCoarsest(const Task& task);
  TileCache::Tile tile(Level level, TilePart part, int number, const Task& task = {}) const;
  std::vector<std::byte> load(Level level, TilePart part, int number, const Task& task) const;
  bool has(TilePart part) const noexcept;
  ColourNodes coloursOf(Level level) const;
  const GridFrame& frame(Level level) const noexcept {
    return facts.frames[static_cast<std::size_t>(level.value)];
  }

  std::filesystem::path file;
  TiledFacts facts;
  std::unique_ptr<MapFiles> files;  ///< One of these two is null.
  std::unique_ptr<PublishedTiles> published;
  std::map<TileName, TileCache::Tile> pinned;  ///< Not changed after opening.
  mutable TileCache cache;
};

TiledMap::Impl::Impl(const std::filesystem::path& finest, std::size_t cache_bytes, const Task& task)
    : file(finest), cache(cache_bytes) {
  if (finest.extension() == ".json") {
    published = std::make_unique<PublishedTiles>(finest);
    takePublished();
    if (published->isRemote()) pinCoarsest(task);
  } else {
    files = std::make_unique<MapFiles>(finest);
    facts = files->facts();
  }
}

void TiledMap::Impl::takePublished() {
  const PublishedMap& map = published->map();
  facts.factor = map.factor;
  facts.view_from_file = {map.view_from_file};
  facts.layOut({.size = map.levels[0],
                .spacing_mm = map.spacing_mm,
                .first_x_mm = map.first_x_mm,
                .first_y_mm = map.first_y_mm},
               map.levels);
  if (facts.oddLevel()) refuseMap(file, said<MessageId::tiles_size_of_no_level>());
  facts.heights = {.min_mm = map.low_mm, .max_mm = map.high_mm};
  if (!facts.takeCounts(map.cells_by_origin))
    refuseMap(file, said<MessageId::tiles_counts_differ>());
  facts.set = map.set;
  facts.state = map.state;
  facts.place = published->place();
}

/// So there is always a level that can be shown and touched without waiting.
void TiledMap::Impl::pinCoarsest(const Task& task) {
  constexpr int kMostTiles = 64;
  constexpr int kMostColoured = 16;  // 1024 cells across: what views of the whole show.
  std::vector<TileName> names, coloured;
  for (int level = static_cast<int>(facts.frames.size()) - 1; level >= 0; --level) {
    const TileLayout layout{frame({level}).size};
    if (2 * layout.count() + static_cast<int>(names.size()) > 2 * kMostTiles && !names.empty()) {
      break;
    }
    for (int number = 0; number < layout.count(); ++number) {
      names.push_back({level, TilePart::heights, number});
      names.push_back({level, TilePart::origins, number});
    }
    if (layout.count() > kMostColoured) continue;
    for (const TilePart part : {TilePart::colours, TilePart::intensities}) {
      for (int number = 0; has(part) && number < layout.count(); ++number) {
        coloured.push_back({level, part, number});
      }
    }
  }
  names.insert(names.end(), coloured.begin(), coloured.end());
  std::vector<TileCache::Tile> tiles(names.size());
  std::atomic<std::size_t> done = 0;
  // Waiting for a server takes no core.
  inParts(0, names.size(), std::min(kWebConnections, static_cast<int>(names.size())),
          [&](int part, std::uint64_t first, std::uint64_t end) {
            for (auto i = static_cast<std::size_t>(first); i < end; ++i) {
              tiles[i] = tile({names[i].level}, names[i].part, names[i].number, task);
              ++done;
              if (part != 0) continue;  // One thread tells.
              task.report("Fetching the map",
                          static_cast<double>(done) / static_cast<double>(names.size()));
            }
          });
  for (std::size_t i = 0; i < names.size(); ++i) pinned[names[i]] = tiles[i];
}

std::vector<std::byte> TiledMap::Impl::load(Level level, TilePart part, int number,
                                            const Task& task) const {
  std::vector<std::byte> bytes = published ? published->read(level.value, part, number, task)
                                           : files->read(level.value, part, number);
  const std::filesystem::path& source = published ? file : files->fileOf(level.value, part);
  if (part == TilePart::heights) checkHeights(bytes, level.value == 0, source);
  if (part == TilePart::origins) checkOrigins(bytes, source);
  return bytes;
}

TileCache::Tile TiledMap::Impl::tile(Level level, TilePart part, int number,
                                     const Task& task) const {
  const auto held = pinned.find({level.value, part, number});
  if (held != pinned.end()) return held->second;
  const TileCache::Key key{.level = level.value, .kind = static_cast<int>(part), .tile = number};
  return cache.get(key, [&] { return load(level, part, number, task); });
}

bool TiledMap::Impl::has(TilePart part) const noexcept {
  if (!published) return files->has(part);
  const auto& parts = published->map().parts;
  return std::find(parts.begin(), parts.end(), part) != parts.end();
}

ColourNodes TiledMap::Impl::coloursOf(Level number) const {
  const GridSize size = frame(number).size;
  const auto rows = [&](auto pixel, TilePart part) {
    using Pixel = decltype(pixel);
    auto made = std::make_shared<FetchedRows<Pixel>>(
        size, [this, number, part](int name) { return tile(number, part, name); });
    return [made](int row, int first_col, int count) { return (*made)(row, first_col, count); };
  };
  ColourNodes nodes;
  if (has(TilePart::colours)) nodes.colours = rows(Rgba{}, TilePart::colours);
  if (has(TilePart::intensities)) nodes.intensities = rows(GreyAlpha{}, TilePart::intensities);
  return nodes;
}

bool TiledMap::isOne(const std::filesystem::path& file) {
  try {
    return inputFacts(file).kind == InputKind::tiled_map;
  } catch (const FileError&) {  // Whoever opens it says so.
    return false;
  }
}

TiledMap::TiledMap(const std::filesystem::path& finest, std::size_t cache_bytes, const Task& task)
    : impl_(std::make_unique<Impl>(finest, cache_bytes, task)) {}
TiledMap::~TiledMap() = default;

const std::filesystem::path& TiledMap::file() const noexcept {
  return impl_->file;
}
std::vector<std::filesystem::path> TiledMap::otherFiles() const {
  return impl_->published ? impl_->published->files() : impl_->files->otherFiles();
}
const std::vector<GridFrame>& TiledMap::frames() const noexcept {
  return impl_->facts.frames;
}
const ViewFromFile& TiledMap::viewFromFile() const noexcept {
  return impl_->facts.view_from_file;
}
const DetailLadder& TiledMap::ladder() const noexcept {
  return impl_->facts.ladder;
}
HeightRange TiledMap::heights() const noexcept {
  return impl_->facts.heights;
}
const std::array<double, kOriginCount>& TiledMap::shares() const noexcept {
  return impl_->facts.shares;
}
std::size_t TiledMap::tilesRead() const noexcept {
  return impl_->cache.loads();
}

RegionWindow TiledMap::window(const Region& region, double gain) const {
  if (region.level.value < 0 || region.level.value >= impl_->facts.ladder.levels()) {
    throw failure<MessageId::map_has_no_such_level>();
  }
  const GridFrame& frame = impl_->frame(region.level);
  FetchedRows<float> heights(
      frame.size, [&](int tile) { return impl_->tile(region.level, TilePart::heights, tile); });
  FetchedRows<CellStatus> origins(
      frame.size, [&](int tile) { return impl_->tile(region.level, TilePart::origins, tile); });
  return sampleWindow({.map = impl_->facts.frames[0],
                       .nodes = frame,
                       .cells = frame,
                       .levels = impl_->facts.ladder.levels(),
                       .heights = std::ref(heights),
                       .origins = std::ref(origins)},
                      region, gain);
}

DepthMap TiledMap::part(Level number, Cell first, GridSize size) const {
  const GridFrame& frame = impl_->frame(number);
  DepthMap map;
  map.frame = frame;
  map.frame.size = size;
  map.frame.first_x_mm = frame.xMm(first.col);
  map.frame.first_y_mm = frame.yMm(first.row);
  map.heights_mm.reserve(size.count());
  map.origins.reserve(size.count());
  FetchedRows<float> heights(
      frame.size, [&](int tile) { return impl_->tile(number, TilePart::heights, tile); });
  FetchedRows<CellStatus> origins(
      frame.size, [&](int tile) { return impl_->tile(number, TilePart::origins, tile); });
  for (int row = first.row; row < first.row + size.rows; ++row) {
    const float* z = heights(row, first.col, size.cols);
    map.heights_mm.insert(map.heights_mm.end(), z, z + size.cols);
    const CellStatus* origin = origins(row, first.col, size.cols);
    map.origins.insert(map.origins.end(), origin, origin + size.cols);
  }
  return map;
}

bool TiledMap::hasColours() const noexcept {
  return impl_->has(TilePart::colours);
}
bool TiledMap::hasIntensities() const noexcept {
  return impl_->has(TilePart::intensities);
}
const std::optional<Message>& TiledMap::coloursLeftAside() const noexcept {
  static const std::optional<Message> kNone;
  return impl_->files ? impl_->files->coloursLeftAside() : kNone;
}

GridColours TiledMap::windowColours(const RegionWindow& window, int ring) const {
  const Level level = window.region.level;
  return relievo::windowColours(impl_->coloursOf(level), impl_->frame(level), window, ring);
}

GridColours TiledMap::partColours(Level level, Cell first, GridSize size) const {
  const ColourNodes nodes = impl_->coloursOf(level);
  GridColours part;
  for (int row = first.row; row < first.row + size.rows; ++row) {
    if (nodes.colours) {
      const Rgba* const line = nodes.colours(row, first.col, size.cols);
      part.colours.insert(part.colours.end(), line, line + size.cols);
    }
    if (nodes.intensities) {
      const GreyAlpha* const line = nodes.intensities(row, first.col, size.cols);
      part.intensities.insert(part.intensities.end(), line, line + size.cols);
    }
  }
  return part;
}

DepthMap TiledMap::levelMap(Level number) const {
  return part(number, {}, impl_->frame(number).size);
}

std::vector<TileName> TiledMap::tilesUnder(const Region& region) const {
  if (region.level.value < 0 || region.level.value >= impl_->facts.ladder.levels()) return {};
  if (!(region.side_mm > 0) || !std::isfinite(region.x_mm + region.y_mm + region.side_mm)) {
    return {};
  }
  const GridFrame& frame = impl_->frame(region.level);
  const auto node = [&](double mm, double first_mm, int count) {
    return std::clamp(static_cast<int>(std::clamp((mm - first_mm) / frame.spacing_mm, -1.0,
                                                  static_cast<double>(count))),
                      0, count - 1);
  };
  // A window's outermost samples lie between two nodes.
  const auto after = [](int first, int count) { return std::min(first + 1, count - 1); };
  const GridSize size = frame.size;
  const int left = node(region.x_mm, frame.first_x_mm, size.cols);
  const int right =
      after(node(region.x_mm + region.side_mm, frame.first_x_mm, size.cols), size.cols);
  const int bottom = node(region.y_mm, frame.first_y_mm, size.rows);
  const int top = after(node(region.y_mm + region.side_mm, frame.first_y_mm, size.rows), size.rows);
  const int across = TileLayout{size}.across();
  std::vector<TileName> names;
  for (const TilePart part :
       {TilePart::heights, TilePart::origins, TilePart::colours, TilePart::intensities}) {
    if (!impl_->has(part)) continue;
    for (int y = (size.rows - 1 - top) / kTileSide; y <= (size.rows - 1 - bottom) / kTileSide;
         ++y) {
      for (int x = left / kTileSide; x <= right / kTileSide; ++x) {
        names.push_back({region.level.value, part, y * across + x});
      }
    }
  }
  return names;
}

void TiledMap::prefetch(const Region& region) const {
  for (const TileName& name : tilesUnder(region)) {
    impl_->tile({name.level}, name.part, name.number);
  }
}

const std::string& TiledMap::set() const noexcept {
  return impl_->facts.set;
}
const std::string& TiledMap::state() const noexcept {
  return impl_->facts.state;
}
const std::string& TiledMap::place() const noexcept {
  return impl_->facts.place;
}
bool TiledMap::isRemote() const noexcept {
  return impl_->published && impl_->published->isRemote();
}
const PublishedMap* TiledMap::published() const noexcept {
  return impl_->published ? &impl_->published->map() : nullptr;
}

TileCache::Tile TiledMap::tile(Level level, TilePart part, int number, const Task& task) const {
  return impl_->tile(level, part, number, task);
}

bool TiledMap::isAtHand(const TileName& tile) const {
  if (impl_->pinned.contains(tile)) return true;
  return impl_->cache.find(
             {.level = tile.level, .kind = static_cast<int>(tile.part), .tile = tile.number}) !=
         nullptr;
}

std::optional<Level> TiledMap::levelAtHand(const Region& region) const {
  for (Region at = region; at.level.value < impl_->facts.ladder.levels(); ++at.level.value) {
    const std::vector<TileName> names = tilesUnder(at);
    const bool all = std::all_of(names.begin(), names.end(), [this](const TileName& name) {
      return name.part > TilePart::origins || isAtHand(name);
    });
    if (all && !names.empty()) return at.level;
  }
  return std::nullopt;
}

bool TiledMap::coloursAtHand(const Region& region) const {
  const std::vector<TileName> names = tilesUnder(region);
  return std::all_of(names.begin(), names.end(), [this](const TileName& name) {
    return name.part <= TilePart::origins || isAtHand(name);
  });
}

}  // namespace relievo
