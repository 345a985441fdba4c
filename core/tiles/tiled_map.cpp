// SPDX-License-Identifier: BSD-3-Clause
#include "core/tiles/tiled_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <optional>
#include <utility>

#include "core/base/failure.h"
#include "core/io/file_check.h"
#include "core/io/formats/number_text.h"
#include "core/io/input_facts.h"
#include "core/io/raster/colour_raster.h"
#include "core/io/raster/tiff_head.h"
#include "core/region/window_colours.h"
#include "core/tiles/level_files.h"
#include "core/tiles/published/published_tiles.h"
#include "core/tiles/threads.h"
#include "core/tiles/tile_cache.h"
#include "core/tiles/tile_layout.h"
#include "core/tiles/tile_raster.h"

namespace relievo {
namespace {

template <MessageId why, class... Given>
[[noreturn]] void refuse(const std::filesystem::path& file, Given&&... given) {
  throw failure<MessageId::tiled_map_unreadable>(shownName(file),
                                                 said<why>(std::forward<Given>(given)...));
}

std::string textOf(const RasterFacts& facts, const std::string& name) {
  const auto found = facts.find(name);
  return found == facts.end() ? std::string() : found->second;
}

template <std::size_t N>
std::array<double, N> numbersOf(const RasterFacts& facts, const std::string& name,
                                const std::filesystem::path& file) {
  const auto numbers = parseNumbers<N>(textOf(facts, name).c_str());
  if (!numbers) refuse<MessageId::tiles_entry_missing>(file, name);
  return *numbers;
}

/// Heights of the finest level are NaN outside the object, where a window has 0.
void checkHeights(std::span<std::byte> bytes, bool nan_is_outside,
                  const std::filesystem::path& file) {
  auto* heights = reinterpret_cast<float*>(bytes.data());
  for (std::size_t i = 0; i < bytes.size() / sizeof(float); ++i) {
    if (std::isfinite(heights[i])) continue;
    if (!nan_is_outside || !std::isnan(heights[i]))
      refuse<MessageId::tiles_height_not_finite>(file);
    heights[i] = 0;
  }
}

void checkOrigins(std::span<const std::byte> bytes, const std::filesystem::path& file) {
  const auto most = static_cast<std::byte>(kOriginCount - 1);
  if (*std::max_element(bytes.begin(), bytes.end()) > most) {
    refuse<MessageId::tiles_no_origin>(file);
  }
}

using Heads = std::map<std::filesystem::path, std::optional<TiffHead>>;

/// Of several files by one process. @throw FileError  one is missing
Heads headsOf(const std::vector<std::filesystem::path>& files) {
  std::vector<std::optional<TiffHead>> read = importTiffHeads(files);
  Heads heads;
  for (std::size_t i = 0; i < files.size(); ++i) heads[files[i]] = std::move(read[i]);
  return heads;
}

struct LevelTiles {
  LevelTiles(const std::filesystem::path& file, int number, const Heads& heads)
      : heights_file(file),
        origins_file(originFile(file)),
        level(number),
        heights(heights_file, heads.at(heights_file), sizeof(float), 1),
        origins(origins_file, heads.at(origins_file), 1, 2) {}

  std::filesystem::path heights_file, origins_file;
  int level;
  TileRaster heights, origins;
  std::unique_ptr<TileRaster> colours, intensities;  ///< Null unless all levels have them.
};

/// Bands of one byte as pixels. @param bands  one after the other, each `cells` bytes
template <std::size_t Size>
std::vector<std::byte> interleaved(std::span<const std::byte> bands) {
  const std::size_t cells = bands.size() / Size;
  std::vector<std::byte> pixels(bands.size());
  for (std::size_t i = 0; i < cells; ++i) {
    for (std::size_t k = 0; k < Size; ++k) pixels[Size * i + k] = bands[k * cells + i];
  }
  return pixels;
}

}  // namespace

struct TiledMap::Impl {
  Impl(const std::filesystem::path& finest, std::size_t cache_bytes);
  void checkLevel(const LevelTiles& tiles, const RasterFacts& facts) const;
  void takeWhole(const RasterFacts& facts);
  TileCache::Tile tile(Level level, TilePart part, int number, const Task& task = {}) const;
  std::vector<std::byte> load(const LevelTiles& tiles, TilePart part, int number) const;
  std::vector<std::byte> pixels(const LevelTiles& tiles, TilePart part, int number) const;
  void openFiles();
  void openPublished();
  void pinCoarsest();
  void layOut(const GridFrame& finest, const std::vector<GridSize>& sizes);
  bool has(TilePart part) const noexcept;
  void openColours();
  ColourNodes coloursOf(Level level) const;

  std::filesystem::path file;
  double factor = 2;
  ViewFromFile view_from_file;
  std::vector<GridFrame> frames;
  DetailLadder ladder;
  HeightRange heights;
  std::array<double, kOriginCount> shares{};
  std::vector<std::unique_ptr<LevelTiles>> levels;
  std::string left_aside, set, state, place;
  std::unique_ptr<PublishedTiles> published;   ///< Then `levels` stays empty.
  std::map<TileName, TileCache::Tile> pinned;  ///< Not changed after opening.
  mutable TileCache cache;
};

TiledMap::Impl::Impl(const std::filesystem::path& finest, std::size_t cache_bytes)
    : file(finest), cache(cache_bytes) {
  if (finest.extension() == ".json") {
    openPublished();
  } else {
    openFiles();
  }
}

void TiledMap::Impl::openFiles() {
  const std::filesystem::path& finest = file;
  levels.push_back(std::make_unique<LevelTiles>(finest, 0, headsOf({finest, originFile(finest)})));
  const RasterFacts& facts = levels[0]->heights.facts();
  constexpr double kMostLevels = 10'000;
  const double count = numbersOf<1>(facts, "RELIEVO_LEVELS", finest)[0];
  factor = numbersOf<1>(facts, "RELIEVO_FACTOR", finest)[0];
  view_from_file = {numbersOf<16>(facts, "RELIEVO_VIEW_FROM_FILE", finest)};
  if (!(count >= 1 && count <= kMostLevels) || !(factor > 1) || !(factor <= kMostFactor)) {
    refuse<MessageId::tiles_levels_odd>(finest);
  }
  std::vector<std::filesystem::path> coarser;
  for (int l = 1; l < static_cast<int>(count); ++l) {
    coarser.push_back(levelFile(finest, l));
    coarser.push_back(originFile(coarser.back()));
  }
  const Heads heads = headsOf(coarser);
  for (int l = 1; l < static_cast<int>(count); ++l) {
    levels.push_back(std::make_unique<LevelTiles>(levelFile(finest, l), l, heads));
  }
  const auto [x, y, spacing] = numbersOf<3>(facts, "RELIEVO_FRAME", finest);
  if (!(spacing > 0)) refuse<MessageId::tiles_spacing_odd>(finest);
  std::vector<GridSize> sizes;
  for (const auto& level : levels) sizes.push_back(level->heights.size());
  layOut({.size = sizes[0], .spacing_mm = spacing, .first_x_mm = x, .first_y_mm = y}, sizes);
  for (const auto& level : levels) checkLevel(*level, facts);
  takeWhole(facts);
  openColours();
  set = textOf(facts, kSetFact);
  state = textOf(facts, kStateFact);
  place = file.string();
}

/// As many levels as there are, whatever number of samples the coarsest was to have.
void TiledMap::Impl::layOut(const GridFrame& finest, const std::vector<GridSize>& sizes) {
  for (std::size_t l = 0; l < sizes.size(); ++l) {
    GridFrame frame = finest;
    frame.size = sizes[l];
    frame.spacing_mm = finest.spacing_mm * std::pow(factor, static_cast<double>(l));
    frames.push_back(frame);
  }
  ladder = {.left_mm = finest.first_x_mm - 0.5 * finest.spacing_mm,
            .bottom_mm = finest.first_y_mm - 0.5 * finest.spacing_mm,
            .width_mm = finest.size.cols * finest.spacing_mm,
            .height_mm = finest.size.rows * finest.spacing_mm,
            .spacings_mm = {},
            .factor = factor};
  for (const GridFrame& frame : frames) ladder.spacings_mm.push_back(frame.spacing_mm);
}

void TiledMap::Impl::openPublished() {
  published = std::make_unique<PublishedTiles>(file);
  const PublishedMap& map = published->map();
  place = published->place();
  factor = map.factor;
  view_from_file = {map.view_from_file};
  layOut({.size = map.levels[0],
          .spacing_mm = map.spacing_mm,
          .first_x_mm = map.first_x_mm,
          .first_y_mm = map.first_y_mm},
         map.levels);
  for (std::size_t l = 1; l < frames.size(); ++l) {
    const GridSize finer = frames[l - 1].size, here = frames[l].size;
    if (here.cols != PyramidRows::reducedSize(finer, factor).cols ||
        here.rows != PyramidRows::reducedSize(finer, factor).rows) {
      refuse<MessageId::tiles_size_of_no_level>(file);
    }
  }
  heights = {.min_mm = map.low_mm, .max_mm = map.high_mm};
  // A double is a whole number up to 2^53 cells.
  const auto cells = static_cast<double>(frames[0].size.count());
  double all = 0;
  for (std::size_t i = 0; i < shares.size(); ++i) {
    all += map.cells_by_origin[i];
    shares[i] = map.cells_by_origin[i] / cells;
  }
  if (all != cells) refuse<MessageId::tiles_counts_differ>(file);
  set = map.set;
  state = map.state;
  if (published->isRemote()) pinCoarsest();
}

/// So there is always a level that can be shown and touched without waiting.
void TiledMap::Impl::pinCoarsest() {
  constexpr int kMostTiles = 64;
  std::vector<TileName> names;
  for (int level = static_cast<int>(frames.size()) - 1; level >= 0; --level) {
    const TileLayout layout{frames[static_cast<std::size_t>(level)].size};
    if (2 * layout.count() + static_cast<int>(names.size()) > 2 * kMostTiles && !names.empty()) {
      break;
    }
    for (int number = 0; number < layout.count(); ++number) {
      names.push_back({level, TilePart::heights, number});
      names.push_back({level, TilePart::origins, number});
    }
  }
  std::vector<TileCache::Tile> tiles(names.size());
  // Waiting for a server takes no core.
  inParts(0, names.size(), std::min(kWebConnections, static_cast<int>(names.size())),
          [&](int /*part*/, std::uint64_t first, std::uint64_t end) {
            for (auto i = static_cast<std::size_t>(first); i < end; ++i) {
              tiles[i] = tile({names[i].level}, names[i].part, names[i].number);
            }
          });
  for (std::size_t i = 0; i < names.size(); ++i) pinned[names[i]] = tiles[i];
}

namespace {

/// A file of pixels that belongs to a level; null if there is none.
/// @throw FileError  it is none that can be read, or of another map
std::unique_ptr<TileRaster> pixelFile(const std::filesystem::path& file, int bands,
                                      const LevelTiles& level, const Heads& heads) {
  const auto head = heads.find(file);
  if (head == heads.end()) return nullptr;
  auto raster = std::make_unique<TileRaster>(file, head->second, 1, bands);
  const RasterFacts& facts = raster->facts();
  const RasterFacts& own = level.heights.facts();
  for (const char* const name : {kSetFact, "RELIEVO_LEVEL"}) {
    if (textOf(facts, name) != textOf(own, name)) refuse<MessageId::tiles_of_another_map>(file);
  }
  if (!(raster->size() == level.heights.size())) refuse<MessageId::tiles_size_of_no_level>(file);
  return raster;
}

}  // namespace

/// Heights are shown without colours rather than with those of another map.
void TiledMap::Impl::openColours() {
  try {
    std::vector<std::filesystem::path> there;
    for (const auto& level : levels) {
      for (const auto& pixels :
           {colourFileOf(level->heights_file), intensityFileOf(level->heights_file)}) {
        std::error_code unknown;
        if (std::filesystem::exists(pixels, unknown)) there.push_back(pixels);
      }
    }
    const Heads heads = headsOf(there);
    for (const auto& level : levels) {
      level->colours = pixelFile(colourFileOf(level->heights_file), 4, *level, heads);
      level->intensities = pixelFile(intensityFileOf(level->heights_file), 2, *level, heads);
    }
  } catch (const FileError& error) {
    left_aside = error.what();
    for (const auto& level : levels) {
      level->colours.reset();
      level->intensities.reset();
    }
    return;
  }
  const auto some_lack = [this](const auto& member) {
    return std::any_of(levels.begin(), levels.end(),
                       [&](const auto& level) { return !((*level).*member); });
  };
  for (const auto member : {&LevelTiles::colours, &LevelTiles::intensities}) {
    if (!some_lack(member)) continue;
    for (const auto& level : levels) ((*level).*member).reset();
  }
}

/// What nobody can see without reading every tile.
void TiledMap::Impl::takeWhole(const RasterFacts& facts) {
  const auto [low, high] = numbersOf<2>(facts, "RELIEVO_HEIGHTS", file);
  if (!(low <= high)) refuse<MessageId::tiles_heights_reversed>(file);
  heights = {.min_mm = low, .max_mm = high};
  const auto cells = static_cast<double>(frames[0].size.count());
  const auto counts = numbersOf<kOriginCount>(facts, "RELIEVO_ORIGINS", file);
  double all = 0;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (!(counts[i] >= 0)) refuse<MessageId::tiles_count_odd>(file);
    all += counts[i];
    shares[i] = counts[i] / cells;
  }
  if (all != cells) refuse<MessageId::tiles_counts_differ>(file);
}

void TiledMap::Impl::checkLevel(const LevelTiles& tiles, const RasterFacts& finest) const {
  const auto belongs = [&](const TileRaster& raster) {
    const RasterFacts& facts = raster.facts();
    return textOf(facts, kSetFact) == textOf(finest, kSetFact) &&
           textOf(facts, "RELIEVO_LEVEL") == std::to_string(tiles.level);
  };
  if (!belongs(tiles.heights)) refuse<MessageId::tiles_level_of_another_map>(tiles.heights_file);
  if (!belongs(tiles.origins) || !(tiles.origins.size() == tiles.heights.size())) {
    refuse<MessageId::tiles_of_another_map>(tiles.origins_file);
  }
  if (tiles.level == 0) return;
  const GridSize finer = frames[static_cast<std::size_t>(tiles.level) - 1].size;
  const GridSize here = tiles.heights.size();
  if (here.cols != PyramidRows::reducedSize(finer, factor).cols ||
      here.rows != PyramidRows::reducedSize(finer, factor).rows) {
    refuse<MessageId::tiles_size_of_no_level>(tiles.heights_file);
  }
}

std::vector<std::byte> TiledMap::Impl::pixels(const LevelTiles& tiles, TilePart part,
                                              int number) const {
  const bool is_colours = part == TilePart::colours;
  const TileRaster& raster = is_colours ? *tiles.colours : *tiles.intensities;
  const int bands = is_colours ? 4 : 2;
  std::vector<std::byte> bytes(static_cast<std::size_t>(bands) * raster.tileBytes());
  for (int band = 0; band < bands; ++band) {
    raster.read(band, number,
                std::span(bytes).subspan(static_cast<std::size_t>(band) * raster.tileBytes(),
                                         raster.tileBytes()));
  }
  return is_colours ? interleaved<4>(bytes) : interleaved<2>(bytes);
}

std::vector<std::byte> TiledMap::Impl::load(const LevelTiles& tiles, TilePart part,
                                            int number) const {
  if (part == TilePart::colours || part == TilePart::intensities) {
    return pixels(tiles, part, number);
  }
  const TileRaster& raster = part == TilePart::heights ? tiles.heights : tiles.origins;
  std::vector<std::byte> bytes(raster.tileBytes());
  raster.read(0, number, bytes);
  return bytes;
}

TileCache::Tile TiledMap::Impl::tile(Level level, TilePart part, int number,
                                     const Task& task) const {
  const auto held = pinned.find({level.value, part, number});
  if (held != pinned.end()) return held->second;
  const TileCache::Key key{.level = level.value, .kind = static_cast<int>(part), .tile = number};
  return cache.get(key, [&] {
    const LevelTiles* const tiles =
        published ? nullptr : levels[static_cast<std::size_t>(level.value)].get();
    std::vector<std::byte> bytes =
        published ? published->read(level.value, part, number, task) : load(*tiles, part, number);
    if (part == TilePart::heights) {
      checkHeights(bytes, level.value == 0, published ? file : tiles->heights_file);
    } else if (part == TilePart::origins) {
      checkOrigins(bytes, published ? file : tiles->origins_file);
    }
    return bytes;
  });
}

bool TiledMap::Impl::has(TilePart part) const noexcept {
  if (published) {
    const auto& parts = published->map().parts;
    return std::find(parts.begin(), parts.end(), part) != parts.end();
  }
  const LevelTiles& finest = *levels.front();
  return part == TilePart::colours       ? finest.colours != nullptr
         : part == TilePart::intensities ? finest.intensities != nullptr
                                         : true;
}

namespace {

/// Rows of one band put together from tiles; the tiles of the last row of tiles stay at hand.
template <class Cell>
class TileRows {
 public:
  using Fetch = std::function<TileCache::Tile(int tile)>;
  TileRows(GridSize size, Fetch fetch) : size_(size), fetch_(std::move(fetch)) {}

  const Cell* operator()(int row, int first_col, int count) {
    const int file_row = size_.rows - 1 - row;
    const int first = first_col / kTileSide;
    const int last = (first_col + count - 1) / kTileSide;
    load(file_row / kTileSide, first, last);
    const auto line = static_cast<std::ptrdiff_t>(file_row % kTileSide) * kTileSide;
    if (first == last) return cells(0) + line + first_col % kTileSide;
    line_.resize(static_cast<std::size_t>(count));
    for (int tile = first; tile <= last; ++tile) {
      const int from = std::max(first_col, tile * kTileSide);
      const int to = std::min(first_col + count, (tile + 1) * kTileSide);
      std::copy_n(cells(tile - first) + line + from % kTileSide, to - from,
                  line_.data() + (from - first_col));
    }
    return line_.data();
  }

 private:
  const Cell* cells(int place) const {
    return reinterpret_cast<const Cell*>(held_[static_cast<std::size_t>(place)]->data());
  }
  void load(int tile_row, int first, int last) {
    if (tile_row == tile_row_ && first == first_ && last == last_) return;
    held_.clear();
    const int across = TileLayout{size_}.across();
    for (int tile = first; tile <= last; ++tile) held_.push_back(fetch_(tile_row * across + tile));
    tile_row_ = tile_row;
    first_ = first;
    last_ = last;
  }

  GridSize size_;
  Fetch fetch_;
  std::vector<TileCache::Tile> held_;
  int tile_row_ = -1, first_ = -1, last_ = -1;
  std::vector<Cell> line_;
};

}  // namespace

ColourNodes TiledMap::Impl::coloursOf(Level number) const {
  const GridSize size = frames[static_cast<std::size_t>(number.value)].size;
  const auto rows = [&](auto pixel, TilePart part) {
    using Pixel = decltype(pixel);
    auto made = std::make_shared<TileRows<Pixel>>(
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

TiledMap::TiledMap(const std::filesystem::path& finest, std::size_t cache_bytes)
    : impl_(std::make_unique<Impl>(finest, cache_bytes)) {}
TiledMap::~TiledMap() = default;

const std::filesystem::path& TiledMap::file() const noexcept {
  return impl_->file;
}
std::vector<std::filesystem::path> TiledMap::otherFiles() const {
  std::vector<std::filesystem::path> files;
  if (impl_->published) return impl_->published->files();
  for (const auto& level : impl_->levels) {
    if (level->level > 0) files.push_back(level->heights_file);
    files.push_back(level->origins_file);
    if (level->colours) files.push_back(colourFileOf(level->heights_file));
    if (level->intensities) files.push_back(intensityFileOf(level->heights_file));
  }
  return files;
}
const std::vector<GridFrame>& TiledMap::frames() const noexcept {
  return impl_->frames;
}
const ViewFromFile& TiledMap::viewFromFile() const noexcept {
  return impl_->view_from_file;
}
const DetailLadder& TiledMap::ladder() const noexcept {
  return impl_->ladder;
}
HeightRange TiledMap::heights() const noexcept {
  return impl_->heights;
}
const std::array<double, kOriginCount>& TiledMap::shares() const noexcept {
  return impl_->shares;
}
std::size_t TiledMap::tilesRead() const noexcept {
  return impl_->cache.loads();
}

RegionWindow TiledMap::window(const Region& region, double gain) const {
  if (region.level.value < 0 || region.level.value >= impl_->ladder.levels()) {
    throw failure<MessageId::map_has_no_such_level>();
  }
  const GridFrame& frame = impl_->frames[static_cast<std::size_t>(region.level.value)];
  TileRows<float> heights(
      frame.size, [&](int tile) { return impl_->tile(region.level, TilePart::heights, tile); });
  TileRows<CellStatus> origins(
      frame.size, [&](int tile) { return impl_->tile(region.level, TilePart::origins, tile); });
  return sampleWindow({.map = impl_->frames[0],
                       .nodes = frame,
                       .cells = frame,
                       .levels = impl_->ladder.levels(),
                       .heights = std::ref(heights),
                       .origins = std::ref(origins)},
                      region, gain);
}

DepthMap TiledMap::part(Level number, Cell first, GridSize size) const {
  const GridFrame& frame = impl_->frames[static_cast<std::size_t>(number.value)];
  DepthMap map;
  map.frame = frame;
  map.frame.size = size;
  map.frame.first_x_mm = frame.xMm(first.col);
  map.frame.first_y_mm = frame.yMm(first.row);
  map.heights_mm.reserve(size.count());
  map.origins.reserve(size.count());
  TileRows<float> heights(frame.size,
                          [&](int tile) { return impl_->tile(number, TilePart::heights, tile); });
  TileRows<CellStatus> origins(
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
const std::string& TiledMap::coloursLeftAside() const noexcept {
  return impl_->left_aside;
}

GridColours TiledMap::windowColours(const RegionWindow& window, int ring) const {
  const Level level = window.region.level;
  return relievo::windowColours(impl_->coloursOf(level),
                                impl_->frames[static_cast<std::size_t>(level.value)], window, ring);
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
  return part(number, {}, impl_->frames[static_cast<std::size_t>(number.value)].size);
}

std::vector<TileName> TiledMap::tilesUnder(const Region& region) const {
  if (region.level.value < 0 || region.level.value >= impl_->ladder.levels()) return {};
  if (!(region.side_mm > 0) || !std::isfinite(region.x_mm + region.y_mm + region.side_mm)) {
    return {};
  }
  const GridFrame& frame = impl_->frames[static_cast<std::size_t>(region.level.value)];
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
  return impl_->set;
}
const std::string& TiledMap::state() const noexcept {
  return impl_->state;
}
const std::string& TiledMap::place() const noexcept {
  return impl_->place;
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
  for (Region at = region; at.level.value < impl_->ladder.levels(); ++at.level.value) {
    const std::vector<TileName> names = tilesUnder(at);
    const bool all = std::all_of(names.begin(), names.end(), [this](const TileName& name) {
      return name.part > TilePart::origins || isAtHand(name);
    });
    if (all && !names.empty()) return at.level;
  }
  return std::nullopt;
}

}  // namespace relievo
