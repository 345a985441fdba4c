// SPDX-License-Identifier: BSD-3-Clause
#include "core/io/raster/colour_raster.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <memory>
#include <system_error>
#include <vector>

#include "core/base/error.h"
#include "core/file/atomic_file.h"
#include "core/file/output_set.h"
#include "core/io/file_check.h"
#include "core/io/raster/colour_content.h"
#include "core/io/raster/raster_file.h"

namespace relievo {
namespace {

constexpr int kRowsAtOnce = 256;  // As high as a tile.

std::filesystem::path beside(std::filesystem::path map_file, const char* ending) {
  return map_file.replace_extension(ending);
}

/// Did this program write it? Looked at as text: GDAL does not read files of others here.
bool isOurs(const std::filesystem::path& file, std::string_view content) {
  constexpr std::size_t kMetadataWithin = std::size_t{1} << 20U;
  const std::string item = "\"" + std::string(kContentFact) + "\">" + std::string(content) + "<";
  try {
    return readHead(file, kMetadataWithin).find(item) != std::string::npos;
  } catch (const FileError&) {
    return false;
  }
}

RasterEntries entriesOf(const DepthMap& map, std::string_view content, const std::string& set) {
  std::vector<float> heights = map.heights_mm;
  for (std::size_t i = 0; i < heights.size(); ++i) {
    if (map.origins[i] == CellStatus::outside) heights[i] = std::numeric_limits<float>::quiet_NaN();
  }
  RasterEntries entries{{kContentFact, std::string(content)},
                        {kColoursOf, std::to_string(heightsChecksum(heights))}};
  if (!set.empty()) entries.emplace_back(kSetFact, set);
  entries.emplace_back("RELIEVO_VERSION", RELIEVO_VERSION_STRING);
  entries.emplace_back("TIFFTAG_SOFTWARE", "relievo " RELIEVO_VERSION_STRING);
  return entries;
}

template <std::size_t Size>
void writePixels(RasterFile& raster, const std::vector<std::array<std::uint8_t, Size>>& pixels,
                 GridSize size) {
  const auto cols = static_cast<std::size_t>(size.cols);
  std::vector<std::array<std::uint8_t, Size>> block(cols * kRowsAtOnce);
  for (int first = 0; first < size.rows && raster.good(); first += kRowsAtOnce) {
    const int rows = std::min(kRowsAtOnce, size.rows - first);
    for (int k = 0; k < rows; ++k) {  // Files begin at the top, maps at the bottom.
      const auto from = static_cast<std::size_t>(size.rows - 1 - first - k);
      std::copy_n(pixels.data() + from * cols, cols,
                  block.data() + static_cast<std::size_t>(k) * cols);
    }
    raster.writePixels(first, rows, block.data());
  }
}

template <std::size_t Size>
void writeCompanion(const OutputFile& place, const DepthMap& map,
                    const std::vector<std::array<std::uint8_t, Size>>& pixels,
                    std::string_view content, const std::string& set) {
  const std::filesystem::path& file = place.path;
  std::error_code unknown;
  const bool there = std::filesystem::exists(file, unknown);
  const bool ours = there && isOurs(file, content);
  if (pixels.empty()) {
    if (ours) place.set->removes(file);  // It would lie about this map.
    return;
  }
  if (there && !ours) {
    cannotWrite(file, "a file of another program has this name; the map's " + std::string(content) +
                          " belong there. Choose another name for the map");
  }
  const GridSize size = map.frame.size;
  if (pixels.size() != size.count()) {
    throw ArgumentError("A map of " + std::to_string(size.count()) + " cells has " +
                        std::to_string(pixels.size()) + " " + std::string(content) + ".");
  }
  AtomicFile written(place);
  const GridFrame& f = map.frame;
  const double half = 0.5 * f.spacing_mm;
  const std::unique_ptr<RasterFile> raster = createRasterFile(
      written.path(),
      {.size = size,
       .bands = static_cast<int>(Size),
       .is_float = false,
       .options = {"COMPRESS=DEFLATE", "PREDICTOR=2", "TILED=YES", "ALPHA=NON-PREMULTIPLIED",
                   Size == 4 ? "PHOTOMETRIC=RGB" : "PHOTOMETRIC=MINISBLACK", "BIGTIFF=IF_SAFER"},
       .transform = {f.first_x_mm - half, f.spacing_mm, 0,
                     f.first_y_mm + (size.rows - 1) * f.spacing_mm + half, 0, -f.spacing_mm},
       .entries = entriesOf(map, content, set)});
  writePixels(*raster, pixels, size);
  raster->close();
  if (!raster->good()) cannotWrite(file, raster->complaint());
  written.commit();
}

}  // namespace

std::filesystem::path colourFileOf(std::filesystem::path map_file) {
  return beside(std::move(map_file), ".colour.tif");
}

std::filesystem::path intensityFileOf(std::filesystem::path map_file) {
  return beside(std::move(map_file), ".intensity.tif");
}

void writeColours(const OutputFile& map_file, const DepthMap& map, const GridColours& colours,
                  const std::string& set) {
  if (map_file.set == nullptr) {
    OutputSet files;
    writeColours(files.file(map_file.path), map, colours, set);
    return files.commit();
  }
  OutputSet& files = *map_file.set;
  writeCompanion(files.file(colourFileOf(map_file.path)), map, colours.colours, kColours, set);
  writeCompanion(files.file(intensityFileOf(map_file.path)), map, colours.intensities, kIntensities,
                 set);
}

void writeMapWithColours(const OutputFile& map_file, const DepthMap& map,
                         const GridColours& colours, const MapFileOptions& options) {
  if (map_file.set == nullptr) {
    OutputSet files;
    writeMapWithColours(files.file(map_file.path), map, colours, options);
    return files.commit();
  }
  MapFileOptions of_set = options;
  if (of_set.set.empty()) of_set.set = setOf(map, colours, options);
  writeColours(map_file, map, colours, of_set.set);
  writeMap(map_file, map, of_set);
}

std::uint64_t heightsChecksum(std::span<const float> heights_mm) {
  std::uint64_t hash = 0x9e3779b97f4a7c15ULL + heights_mm.size();
  for (const float height : heights_mm) {
    // All that is no height is the same, and so are both zeros.
    const std::uint32_t bits = std::isnan(height) ? 0x7fc00000U
                               : height == 0      ? 0U
                                                  : std::bit_cast<std::uint32_t>(height);
    hash = (hash ^ bits) * 0x100000001b3ULL;
    hash ^= hash >> 29U;
  }
  return hash;
}

}  // namespace relievo
