// SPDX-License-Identifier: BSD-3-Clause
#include "core/tiles/level_files.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>

#include "core/hash/sha256.h"
#include "core/io/formats/number_text.h"
#include "core/io/raster/raster.h"
#include "core/io/raster/tiff_head.h"
#include "core/tiles/colours/colour_files.h"
#include "core/tiles/tile_raster.h"

namespace relievo {

std::filesystem::path levelFile(const std::filesystem::path& finest, int level) {
  if (level == 0) return finest;
  std::filesystem::path stem = finest.stem();
  if (stem.extension() == ".L0") stem = stem.stem();
  return finest.parent_path() /
         (stem.string() + ".L" + std::to_string(level) + finest.extension().string());
}

std::filesystem::path originFile(const std::filesystem::path& level) {
  std::filesystem::path file = level;
  return file.replace_extension(".origin.tif");
}

namespace {

/// Is this a level's file that we wrote? Anything else of that name is left alone.
bool isLevel(const std::filesystem::path& file, int level) {
  const RasterFacts facts = rasterFacts(file);
  const auto number = facts.find("RELIEVO_LEVEL");
  return number != facts.end() && number->second == std::to_string(level);
}

}  // namespace

struct LevelFiles::Level {
  Level(const std::filesystem::path& file, const GridFrame& frame, int number, OutputSet& set)
      : heights(set.file(file), frame, {.cell_bytes = 4, .bands = 1, .nan_is_nodata = number == 0}),
        origins(set.file(originFile(file)), frame, {.cell_bytes = 1, .bands = 2}),
        line(static_cast<std::size_t>(frame.size.cols)),
        codes(line.size()),
        shares(line.size()) {
    if (number > 0) mask.emplace(frame.size);
  }

  TileRasterWriter heights, origins;
  std::optional<BitRows> mask;
  std::vector<float> line;
  std::vector<std::uint8_t> codes, shares;
};

LevelFiles::LevelFiles(const std::filesystem::path& finest, const GridFrame& map,
                       const PyramidOptions& options)
    : finest_(finest),
      options_(options),
      frames_(PyramidRows::frames(map, options)),
      pyramid_(map, options, [this](const LevelRow& row) { take(row); }) {
  // Nobody named these files; what is there under their names may be anybody's.
  for (int level = 0; level < static_cast<int>(frames_.size()); ++level) {
    const std::filesystem::path file = levelFile(finest, level);
    if (level > 0) requireOwnOrAbsent(file);
    requireOwnOrAbsent(originFile(file));
  }
  for (int level = 0; level < static_cast<int>(frames_.size()); ++level) {
    levels_.push_back(std::make_unique<Level>(
        levelFile(finest, level), frames_[static_cast<std::size_t>(level)], level, files_));
  }
}

LevelFiles::~LevelFiles() = default;

void LevelFiles::add(const float* heights_mm, const CellStatus* origins) {
  pyramid_.add(heights_mm, origins);
}

void LevelFiles::take(const LevelRow& row) {
  Level& level = *levels_[static_cast<std::size_t>(row.level.value)];
  for (std::size_t col = 0; col < level.line.size(); ++col) {
    const bool outside = row.origins[col] == CellStatus::outside;
    level.codes[col] = static_cast<std::uint8_t>(row.origins[col]);
    level.shares[col] = static_cast<std::uint8_t>(std::lround(255 * row.measured[col]));
    level.line[col] = row.heights_mm[col];
    if (level.mask) {
      if (!outside) level.mask->set({.col = static_cast<int>(col), .row = row.row});
    } else {
      if (outside) level.line[col] = std::numeric_limits<float>::quiet_NaN();
      takeFinest(row.heights_mm[col], row.origins[col]);
    }
  }
  const std::array<const void*, 1> heights{level.line.data()};
  level.heights.add(heights);
  const std::array<const void*, 2> origins{level.codes.data(), level.shares.data()};
  level.origins.add(origins);
}

void LevelFiles::takeFinest(float height_mm, CellStatus origin) {
  // One multiplication per cell: it need not withstand an attack.
  content_ = (content_ ^ std::bit_cast<std::uint32_t>(height_mm)) * 0x9e3779b97f4a7c15ULL;
  content_ ^= (content_ >> 29U) + static_cast<std::uint64_t>(origin);
  ++counts_[static_cast<std::size_t>(origin)];
  if (origin == CellStatus::outside) return;
  low_mm_ = std::min(low_mm_, height_mm);
  high_mm_ = std::max(high_mm_, height_mm);
}

/// All that makes one map another: what its files say beyond this follows from it. Colours do from
/// the state, and whether there are any depends on the memory, as nothing else in the files does.
std::string LevelFiles::setOf(const ViewFromFile& view_from_file, const std::string& state) const {
  const GridFrame& frame = frames_.front();
  const auto cells = static_cast<double>(frame.size.cols);
  return sha256OfText(std::to_string(content_) + "\n" + roundTripText(view_from_file.m) + "\n" +
                      roundTripText(std::array{frame.first_x_mm, frame.first_y_mm, frame.spacing_mm,
                                               cells, options_.factor}) +
                      "\n" + state);
}

void LevelFiles::finish(const ViewFromFile& view_from_file, const std::string& state,
                        ColourFiles* colours) {
  const std::string set = setOf(view_from_file, state);
  const bool any = low_mm_ <= high_mm_;
  const std::array<double, 2> heights{any ? static_cast<double>(low_mm_) : 0,
                                      any ? static_cast<double>(high_mm_) : 0};
  const std::vector<double> origins(counts_.begin(), counts_.end());  // Exact: below 2^53.
  for (std::size_t l = 0; l < levels_.size(); ++l) {
    const GridFrame& frame = frames_[l];
    RasterFacts facts{{"RELIEVO_UNIT", "mm"},
                      {"RELIEVO_VERSION", RELIEVO_VERSION_STRING},
                      {"RELIEVO_VIEW_FROM_FILE", roundTripText(view_from_file.m)},
                      {"RELIEVO_FRAME", roundTripText(std::array{frame.first_x_mm, frame.first_y_mm,
                                                                 frame.spacing_mm})},
                      {"RELIEVO_LEVEL", std::to_string(l)},
                      {"RELIEVO_LEVELS", std::to_string(levels_.size())},
                      {"RELIEVO_FACTOR", roundTripText(std::array{options_.factor})},
                      {"RELIEVO_HEIGHTS", roundTripText(heights)},
                      {"RELIEVO_ORIGINS", roundTripText(origins)},
                      {kSetFact, set}};
    if (!state.empty()) facts[kStateFact] = state;
    Level& level = *levels_[l];
    level.heights.close(facts, level.mask ? &*level.mask : nullptr);
    facts["RELIEVO_CONTENT"] = "origins";
    level.origins.close(facts, nullptr);
  }
  if (colours != nullptr) {
    colours->finish(set);
    files_.takes(colours->files());
  }
  // The finest last: it is the one that says how many levels there are.
  for (std::size_t l = levels_.size(); l-- > 0;) {
    levels_[l]->origins.commit();
    levels_[l]->heights.commit();
  }
  const int count = static_cast<int>(levels_.size());
  for (int l = 0; l < count; ++l) {
    ColourFiles::removeStale(levelFile(finest_, l), colours != nullptr && colours->hasColours(),
                             colours != nullptr && colours->hasIntensities(), files_);
  }
  removeLevelsFrom(finest_, count, files_);
  files_.commit();
}

void removeLevelsFrom(const std::filesystem::path& finest, int count, OutputSet& set) {
  for (int l = count; isLevel(levelFile(finest, l), l); ++l) {
    const std::filesystem::path stale = levelFile(finest, l);
    set.removes(stale);
    ColourFiles::removeStale(stale, false, false, set);
    if (isLevel(originFile(stale), l)) set.removes(originFile(stale));
  }
}

}  // namespace relievo
