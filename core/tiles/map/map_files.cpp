// SPDX-License-Identifier: BSD-3-Clause
#include "core/tiles/map/map_files.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <span>
#include <system_error>
#include <utility>

#include "core/base/failure.h"
#include "core/io/file_check.h"
#include "core/io/formats/number_text.h"
#include "core/io/raster/colour_raster.h"
#include "core/io/raster/tiff_head.h"
#include "core/tiles/level_files.h"
#include "core/tiles/tile_raster.h"

namespace relievo {
namespace {

using Path = std::filesystem::path;
using Heads = std::map<Path, std::optional<TiffHead>>;

std::string textOf(const RasterFacts& facts, const std::string& name) {
  const auto found = facts.find(name);
  return found == facts.end() ? std::string() : found->second;
}

template <std::size_t N>
std::array<double, N> numbersOf(const RasterFacts& facts, const std::string& name,
                                const Path& file) {
  const auto numbers = parseNumbers<N>(textOf(facts, name).c_str());
  if (!numbers) refuseMap(file, said<MessageId::tiles_entry_missing>(name));
  return *numbers;
}

/// Of several files by one process. @throw FileError  one is missing
Heads headsOf(const std::vector<Path>& files) {
  std::vector<std::optional<TiffHead>> read = importTiffHeads(files);
  Heads heads;
  for (std::size_t i = 0; i < files.size(); ++i) heads[files[i]] = std::move(read[i]);
  return heads;
}

/// Whether two files state the same. @param names  the facts that are compared
bool agree(const TileRaster& one, const TileRaster& other, std::span<const char* const> names) {
  return std::all_of(names.begin(), names.end(), [&](const char* const name) {
    return textOf(one.facts(), name) == textOf(other.facts(), name);
  });
}

constexpr const char* kLevelNumberFact = "RELIEVO_LEVEL";
constexpr std::array kOfALevel{kSetFact, kLevelNumberFact};

/// A file of pixels that belongs to a level; null if there is none.
/// @param heights  the level's @throw FileError  it cannot be read, or is of another map
std::unique_ptr<TileRaster> pixelFile(const Path& file, int bands, const TileRaster& heights,
                                      const Heads& heads) {
  const auto head = heads.find(file);
  if (head == heads.end()) return nullptr;
  auto raster = std::make_unique<TileRaster>(file, head->second, 1, bands);
  if (!agree(*raster, heights, kOfALevel)) refuseMap(file, said<MessageId::tiles_of_another_map>());
  if (!(raster->size() == heights.size()))
    refuseMap(file, said<MessageId::tiles_size_of_no_level>());
  return raster;
}

/// Joins bands of one byte to pixels. @param bands  one after the other
std::vector<std::byte> interleaved(std::span<const std::byte> bands, std::size_t count) {
  const std::size_t cells = bands.size() / count;
  std::vector<std::byte> pixels(bands.size());
  for (std::size_t i = 0; i < cells; ++i) {
    for (std::size_t k = 0; k < count; ++k) pixels[count * i + k] = bands[k * cells + i];
  }
  return pixels;
}

}  // namespace

struct MapFiles::LevelTiles {
  LevelTiles(const Path& file, int number, const Heads& heads)
      : heights_file(file),
        origins_file(originFile(file)),
        level(number),
        heights(heights_file, heads.at(heights_file), sizeof(float), 1),
        origins(origins_file, heads.at(origins_file), 1, 2) {}

  /// @param finest  heights of the finest level @throw FileError
  void checkBelongsTo(const TileRaster& finest) const {
    if (!agree(heights, finest, std::array{kSetFact}) ||
        textOf(heights.facts(), kLevelNumberFact) != std::to_string(level)) {
      refuseMap(heights_file, said<MessageId::tiles_level_of_another_map>());
    }
    if (!agree(origins, heights, kOfALevel) || !(origins.size() == heights.size())) {
      refuseMap(origins_file, said<MessageId::tiles_of_another_map>());
    }
  }

  Path heights_file, origins_file;
  int level;
  TileRaster heights, origins;
  std::unique_ptr<TileRaster> colours, intensities;  ///< Null unless all levels have them.
};

void refuseMap(const Path& file, Message why) {
  throw failure<MessageId::tiled_map_unreadable>(shownName(file), std::move(why));
}

MapFiles::MapFiles(const Path& finest) {
  levels_.push_back(std::make_unique<LevelTiles>(finest, 0, headsOf({finest, originFile(finest)})));
  const RasterFacts& facts = levels_[0]->heights.facts();
  constexpr double kMostLevels = 10'000;
  const double count = numbersOf<1>(facts, "RELIEVO_LEVELS", finest)[0];
  facts_.factor = numbersOf<1>(facts, "RELIEVO_FACTOR", finest)[0];
  facts_.view_from_file = {numbersOf<16>(facts, "RELIEVO_VIEW_FROM_FILE", finest)};
  if (!(count >= 1 && count <= kMostLevels) || !(facts_.factor > 1) ||
      !(facts_.factor <= kMostFactor)) {
    refuseMap(finest, said<MessageId::tiles_levels_odd>());
  }
  openCoarser(finest, static_cast<int>(count));
  const auto [x, y, spacing] = numbersOf<3>(facts, "RELIEVO_FRAME", finest);
  if (!(spacing > 0)) refuseMap(finest, said<MessageId::tiles_spacing_odd>());
  std::vector<GridSize> sizes;
  for (const auto& level : levels_) sizes.push_back(level->heights.size());
  facts_.layOut({.size = sizes[0], .spacing_mm = spacing, .first_x_mm = x, .first_y_mm = y}, sizes);
  for (const auto& level : levels_) level->checkBelongsTo(levels_[0]->heights);
  if (const auto odd = facts_.oddLevel()) {
    refuseMap(levels_[*odd]->heights_file, said<MessageId::tiles_size_of_no_level>());
  }
  takeWhole(finest);
  openColours();
  facts_.set = textOf(facts, kSetFact);
  facts_.state = textOf(facts, kStateFact);
  facts_.place = finest.string();
}

MapFiles::~MapFiles() = default;

void MapFiles::openCoarser(const Path& finest, int count) {
  std::vector<Path> files;
  for (int l = 1; l < count; ++l) {
    files.push_back(levelFile(finest, l));
    files.push_back(originFile(files.back()));
  }
  const Heads heads = headsOf(files);
  for (int l = 1; l < count; ++l) {
    levels_.push_back(std::make_unique<LevelTiles>(levelFile(finest, l), l, heads));
  }
}

/// Facts that can otherwise be known only by reading every tile.
void MapFiles::takeWhole(const Path& finest) {
  const RasterFacts& facts = levels_[0]->heights.facts();
  const auto [low, high] = numbersOf<2>(facts, "RELIEVO_HEIGHTS", finest);
  if (!(low <= high)) refuseMap(finest, said<MessageId::tiles_heights_reversed>());
  facts_.heights = {.min_mm = low, .max_mm = high};
  const auto counts = numbersOf<kOriginCount>(facts, "RELIEVO_ORIGINS", finest);
  if (std::any_of(counts.begin(), counts.end(), [](double cells) { return !(cells >= 0); })) {
    refuseMap(finest, said<MessageId::tiles_count_odd>());
  }
  if (!facts_.takeCounts(counts)) refuseMap(finest, said<MessageId::tiles_counts_differ>());
}

/// Heights are shown without colours rather than with those of another map.
void MapFiles::openColours() {
  try {
    std::vector<Path> there;
    for (const auto& level : levels_) {
      for (const Path& pixels :
           {colourFileOf(level->heights_file), intensityFileOf(level->heights_file)}) {
        std::error_code unknown;
        if (std::filesystem::exists(pixels, unknown)) there.push_back(pixels);
      }
    }
    const Heads heads = headsOf(there);
    for (const auto& level : levels_) {
      level->colours = pixelFile(colourFileOf(level->heights_file), 4, level->heights, heads);
      level->intensities =
          pixelFile(intensityFileOf(level->heights_file), 2, level->heights, heads);
    }
  } catch (const FileError& error) {
    left_aside_ = messageOf(error);
  }
  for (const auto member : {&LevelTiles::colours, &LevelTiles::intensities}) {
    const bool some_lack = left_aside_.has_value() ||
                           std::any_of(levels_.begin(), levels_.end(),
                                       [member](const auto& level) { return !((*level).*member); });
    if (!some_lack) continue;
    for (const auto& level : levels_) ((*level).*member).reset();
  }
}

bool MapFiles::has(TilePart part) const noexcept {
  const LevelTiles& finest = *levels_.front();
  return part == TilePart::colours       ? finest.colours != nullptr
         : part == TilePart::intensities ? finest.intensities != nullptr
                                         : true;
}

std::vector<Path> MapFiles::otherFiles() const {
  std::vector<Path> files;
  for (const auto& level : levels_) {
    if (level->level > 0) files.push_back(level->heights_file);
    files.push_back(level->origins_file);
    if (level->colours) files.push_back(colourFileOf(level->heights_file));
    if (level->intensities) files.push_back(intensityFileOf(level->heights_file));
  }
  return files;
}

const Path& MapFiles::fileOf(int level, TilePart part) const noexcept {
  const LevelTiles& tiles = *levels_[static_cast<std::size_t>(level)];
  return part == TilePart::origins ? tiles.origins_file : tiles.heights_file;
}

std::vector<std::byte> MapFiles::read(int level, TilePart part, int tile) const {
  const LevelTiles& tiles = *levels_[static_cast<std::size_t>(level)];
  // The second band of origins is a share that other programs may look at.
  const auto [raster, bands] = part == TilePart::heights   ? std::pair(&tiles.heights, 1)
                               : part == TilePart::origins ? std::pair(&tiles.origins, 1)
                               : part == TilePart::colours
                                   ? std::pair(std::as_const(tiles.colours).get(), 4)
                                   : std::pair(std::as_const(tiles.intensities).get(), 2);
  std::vector<std::byte> bytes(static_cast<std::size_t>(bands) * raster->tileBytes());
  for (int band = 0; band < bands; ++band) {
    raster->read(band, tile,
                 std::span(bytes).subspan(static_cast<std::size_t>(band) * raster->tileBytes(),
                                          raster->tileBytes()));
  }
  return bands == 1 ? bytes : interleaved(bytes, static_cast<std::size_t>(bands));
}

}  // namespace relievo
