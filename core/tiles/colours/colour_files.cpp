// SPDX-License-Identifier: BSD-3-Clause
#include "core/tiles/colours/colour_files.h"

#include <array>
#include <cstdint>
#include <optional>
#include <utility>

#include "core/io/raster/colour_raster.h"
#include "core/io/raster/tiff_head.h"
#include "core/tiles/level_files.h"
#include "core/tiles/tile_raster.h"

namespace relievo {
namespace {

/// A file of pixels, band by band.
template <std::size_t Size>
struct PixelFile {
  PixelFile(const OutputFile& file, const GridFrame& frame)
      : writer(file, frame, {.cell_bytes = 1, .bands = static_cast<int>(Size), .has_alpha = true}) {
    for (auto& plane : planes) plane.resize(static_cast<std::size_t>(frame.size.cols));
  }

  void add(const std::array<std::uint8_t, Size>* pixels) {
    std::array<const void*, Size> bands{};
    for (std::size_t k = 0; k < Size; ++k) {
      for (std::size_t i = 0; i < planes[k].size(); ++i) planes[k][i] = pixels[i][k];
      bands[k] = planes[k].data();
    }
    writer.add(bands);
  }

  TileRasterWriter writer;
  std::array<std::vector<std::uint8_t>, Size> planes;
};

constexpr const char* kColours = "colours";
constexpr const char* kIntensities = "intensities";

bool isOurs(const std::filesystem::path& file, const char* content) {
  const RasterFacts facts = rasterFacts(file);
  const auto found = facts.find("RELIEVO_CONTENT");
  return found != facts.end() && found->second == content;
}

}  // namespace

struct ColourFiles::Level {
  std::optional<PixelFile<4>> colours;
  std::optional<PixelFile<2>> intensities;
};

ColourFiles::ColourFiles(const std::filesystem::path& finest, std::vector<GridFrame> frames,
                         double factor, bool colours, bool intensities)
    : colours_(colours),
      intensities_(intensities),
      pyramid_(frames, factor, [this](const ColourRow& row) { take(row); }) {
  for (std::size_t l = 0; l < frames.size(); ++l) {
    const std::filesystem::path file = levelFile(finest, static_cast<int>(l));
    requireFree(file);
    auto level = std::make_unique<Level>();
    if (colours) level->colours.emplace(files_.file(colourFileOf(file)), frames[l]);
    if (intensities) level->intensities.emplace(files_.file(intensityFileOf(file)), frames[l]);
    levels_.push_back(std::move(level));
  }
}

ColourFiles::~ColourFiles() = default;

void ColourFiles::add(const Rgba* colours, const GreyAlpha* intensities) {
  pyramid_.add(colours, intensities);
}

void ColourFiles::take(const ColourRow& row) {
  Level& level = *levels_[static_cast<std::size_t>(row.level.value)];
  if (level.colours) level.colours->add(row.colours);
  if (level.intensities) level.intensities->add(row.intensities);
}

void ColourFiles::finish(const std::string& set) {
  for (std::size_t l = 0; l < levels_.size(); ++l) {
    RasterFacts facts{{"RELIEVO_VERSION", RELIEVO_VERSION_STRING},
                      {"RELIEVO_LEVEL", std::to_string(l)},
                      {kSetFact, set}};
    Level& level = *levels_[l];
    facts["RELIEVO_CONTENT"] = kColours;
    if (level.colours) level.colours->writer.close(facts, nullptr);
    facts["RELIEVO_CONTENT"] = kIntensities;
    if (level.intensities) level.intensities->writer.close(facts, nullptr);
  }
  for (const auto& level : levels_) {
    if (level->colours) level->colours->writer.commit();
    if (level->intensities) level->intensities->writer.commit();
  }
}

void ColourFiles::requireFree(const std::filesystem::path& level) {
  requireOwnOrAbsent(colourFileOf(level));
  requireOwnOrAbsent(intensityFileOf(level));
}

void ColourFiles::removeStale(const std::filesystem::path& level, bool colours, bool intensities,
                              OutputSet& set) {
  if (!colours && isOurs(colourFileOf(level), kColours)) set.removes(colourFileOf(level));
  if (!intensities && isOurs(intensityFileOf(level), kIntensities)) {
    set.removes(intensityFileOf(level));
  }
}

}  // namespace relievo
