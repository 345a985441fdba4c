// SPDX-License-Identifier: BSD-3-Clause
// Maps and exports as GeoTIFF.
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <future>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/file/atomic_file.h"
#include "core/file/output_set.h"
#include "core/file/owned_fd.h"
#include "core/hash/sha256.h"
#include "core/io/export/export_grid.h"
#include "core/io/formats/number_text.h"
#include "core/io/raster/map_file.h"
#include "core/io/raster/raster.h"
#include "core/io/raster/raster_file.h"
#include "core/io/raster/tiff_head.h"

namespace relievo {
namespace {

/// One band, row 0 of `cells` at the lowest y, which is the last row of the file.
struct BandToWrite {
  const void* cells;
  bool is_float;
  const std::vector<std::uint8_t>* mask = nullptr;  ///< 255 where the cell counts, else 0.
};

/// Where the samples lie, in view mm or in a file's unit.
struct RasterPlace {
  GridSize size;
  double first_x = 0, first_y = 0, spacing = 1;
  const char* projection = "";
  std::string unit = {};  ///< Of the heights, as programs that read GeoTIFF expect it; or empty.
};

RasterPlace placeOf(const GridFrame& frame) {
  return {frame.size, frame.first_x_mm, frame.first_y_mm, frame.spacing_mm, kViewSystem};
}

void writeRows(RasterFile& file, int band, GridSize size, const void* cells,
               std::size_t cell_bytes) {
  const auto* bottom_up = static_cast<const std::uint8_t*>(cells);
  const std::size_t line_bytes = static_cast<std::size_t>(size.cols) * cell_bytes;
  for (int file_row = 0; file_row < size.rows && file.good(); ++file_row) {
    const auto row = static_cast<std::size_t>(size.rows - 1 - file_row);
    file.writeRows(band, file_row, 1, bottom_up + row * line_bytes,
                   static_cast<std::ptrdiff_t>(line_bytes));
  }
}

RasterSpec specOf(const RasterPlace& place, const RasterEntries& entries) {
  const double s = place.spacing;
  return {.size = place.size,
          .transform = {place.first_x - 0.5 * s, s, 0,
                        place.first_y + (place.size.rows - 1) * s + 0.5 * s, 0, -s},
          .projection = place.projection,
          .unit = place.unit,
          .entries = entries};
}

void writeBand(const std::filesystem::path& file, const std::filesystem::path& shown,
               const RasterPlace& place, const BandToWrite& band, const RasterEntries& entries) {
  RasterSpec spec = specOf(place, entries);
  spec.is_float = spec.nan_is_nodata = band.is_float;
  // Strips of several rows, by the least level: measured, noise in the heights is as small by it as
  // by the most, in half the time (docs/adr/0206-maps-packed-sooner.md).
  spec.options = {"COMPRESS=DEFLATE", "ZLEVEL=1", "BLOCKYSIZE=16", "BIGTIFF=IF_SAFER",
                  "NUM_THREADS=ALL_CPUS"};
  if (band.is_float) spec.options.push_back("PREDICTOR=3");
  const std::unique_ptr<RasterFile> raster = createRasterFile(file, spec);
  writeRows(*raster, 1, place.size, band.cells, band.is_float ? sizeof(float) : 1);
  if (band.mask != nullptr) {
    raster->addMask();
    writeRows(*raster, RasterFile::kMask, place.size, band.mask->data(), 1);
  }
  raster->close();
  if (!raster->good()) cannotWrite(shown, raster->complaint());
}

void checkMap(const DepthMap& map) {
  const GridSize size = map.frame.size;
  if (size.cols < 1 || size.rows < 1 || !(map.frame.spacing_mm > 0) ||
      map.heights_mm.size() != size.count() || map.origins.size() != size.count()) {
    throw ArgumentError("A map of " + std::to_string(size.cols) + " x " +
                        std::to_string(size.rows) + " cells cannot be written: it has " +
                        std::to_string(map.heights_mm.size()) + " heights and " +
                        std::to_string(map.origins.size()) + " origins.");
  }
}

/// Waits for a file's bytes here rather than where others wait for it, too. By a descriptor of its
/// own: what goes wrong is said where the file is made to stay.
void startToDisk(const std::filesystem::path& written) {
  const OwnedFd file(::open(written.c_str(), O_RDONLY | O_CLOEXEC));
  if (file.get() >= 0) ::fsync(file.get());
}

RasterEntries entriesOf(const DepthMap& map, const MapFileOptions& options) {
  const GridFrame& frame = map.frame;
  RasterEntries entries{
      {"RELIEVO_UNIT", options.unit},
      {"RELIEVO_VERSION", RELIEVO_VERSION_STRING},
      {"RELIEVO_VIEW_FROM_FILE", roundTripText(options.view_from_file.m)},
      {"RELIEVO_FRAME",
       roundTripText(std::array{frame.first_x_mm, frame.first_y_mm, frame.spacing_mm})},
      {"TIFFTAG_SOFTWARE", "relievo " RELIEVO_VERSION_STRING}};
  if (!options.state.empty()) entries.emplace_back(kDescriptionTag, options.state);
  entries.emplace_back(kSetFact, options.set.empty() ? setOf(map, {}, options) : options.set);
  if (!options.what.empty()) entries.emplace_back(kContentFact, options.what);
  if (options.level) entries.emplace_back(kLevelFact, std::to_string(*options.level));
  return entries;
}

/// The same of a map's origins.
RasterEntries asOrigins(RasterEntries entries) {
  const auto content =
      std::ranges::find(entries, std::string_view(kContentFact), &RasterEntries::value_type::first);
  if (content == entries.end()) {
    entries.emplace_back(kContentFact, kOriginContent);
  } else {
    content->second = kOriginContent;
  }
  return entries;
}

}  // namespace

std::string setOf(const DepthMap& map, const GridColours& colours, const MapFileOptions& options) {
  Sha256 sum;
  const auto add = [&sum](const auto& list) { sum.add(std::as_bytes(std::span(list))); };
  add(map.heights_mm);
  add(map.origins);
  add(colours.colours);
  add(colours.intensities);
  add(options.view_from_file.m);
  const GridFrame& frame = map.frame;
  add(std::array{frame.first_x_mm, frame.first_y_mm, frame.spacing_mm,
                 static_cast<double>(frame.size.cols), static_cast<double>(frame.size.rows)});
  sum.add(options.state);
  return sum.finish();
}

void writeMap(const OutputFile& place, const DepthMap& map, const MapFileOptions& options) {
  checkMap(map);
  if (place.set == nullptr) {
    OutputSet set;
    writeMap(set.file(place.path), map, options);
    return set.commit();
  }
  OutputSet& set = *place.set;
  const std::filesystem::path& file = place.path;
  std::vector<float> heights = map.heights_mm;
  std::vector<std::uint8_t> codes(map.origins.size());
  std::vector<std::uint8_t> mask(map.origins.size(), 255);
  for (std::size_t i = 0; i < codes.size(); ++i) {
    codes[i] = static_cast<std::uint8_t>(map.origins[i]);
    if (map.origins[i] != CellStatus::outside) continue;
    mask[i] = 0;
    if (options.outside_as_nan) heights[i] = kNoHeight;
  }
  const RasterEntries entries = entriesOf(map, options);

  const std::filesystem::path origin_name = originFileOf(file);
  if (options.write_origins) requireOwnOrAbsent(origin_name);
  AtomicFile map_file(place);
  std::optional<AtomicFile> origin_file;
  std::future<void> origins;  // Beside the heights: both are mostly compression.
  if (options.write_origins) {
    origin_file.emplace(set.file(origin_name));
    origins = std::async(std::launch::async, [&] {
      writeBand(origin_file->path(), origin_name, placeOf(map.frame), {codes.data(), false},
                asOrigins(entries));
      startToDisk(origin_file->path());
    });
  } else if (isOwnTiff(origin_name)) {
    set.removes(origin_name);  // An older map's would lie about this one.
  }
  writeBand(map_file.path(), file, placeOf(map.frame),
            {heights.data(), true, options.mask_band ? &mask : nullptr}, entries);
  if (origin_file) {
    origins.get();
    origin_file->commit();
  }
  map_file.commit();
}

namespace {

RasterEntries entriesOf(const ExportGrid& grid) {
  RasterEntries entries{{"RELIEVO_VERSION", RELIEVO_VERSION_STRING},
                        {"HEIGHT_UNIT", grid.unit},
                        {"TIFFTAG_SOFTWARE", "relievo " RELIEVO_VERSION_STRING}};
  if (!grid.state.empty()) entries.emplace_back(kDescriptionTag, grid.state);
  return entries;
}

RasterPlace placeOf(const ExportGrid& grid) {
  return {grid.size,
          grid.first_x,
          grid.first_y,
          grid.spacing,
          grid.is_view ? kViewSystem : grid.projection.c_str(),
          grid.unit};
}

}  // namespace

void writeGeoTiff(const std::filesystem::path& file, const ExportGrid& grid) {
  std::vector<float> heights = grid.heights;
  std::vector<std::uint8_t> mask(heights.size(), 255);
  for (std::size_t i = 0; i < heights.size(); ++i) {
    if (grid.holds(i)) continue;
    heights[i] = kNoHeight;
    mask[i] = 0;
  }
  AtomicFile written(file);
  writeBand(written.path(), file, placeOf(grid), {heights.data(), true, &mask}, entriesOf(grid));
  written.commit();
}

void writeCloudGeoTiff(const std::filesystem::path& file, const ExportGrid& grid,
                       const Task& task) {
  // The driver writes overviews beside the file before they are in it.
  AtomicFile written(file, TemporaryName::beside);
  std::vector<float> heights = grid.heights;
  for (std::size_t i = 0; i < heights.size(); ++i) {
    if (!grid.holds(i)) heights[i] = kNoHeight;
  }
  RasterSpec spec = specOf(placeOf(grid), entriesOf(grid));
  spec.nan_is_nodata = true;
  // The driver copies what is complete: its first bytes say where everything is.
  const std::unique_ptr<RasterFile> whole = createRasterFile({}, spec);
  writeRows(*whole, 1, grid.size, heights.data(), sizeof(float));
  std::vector<float>().swap(heights);
  whole->copyForClouds(written.path(),
                       {"COMPRESS=DEFLATE", "PREDICTOR=YES", "BLOCKSIZE=512", "OVERVIEWS=AUTO",
                        "RESAMPLING=AVERAGE", "BIGTIFF=IF_SAFER"},
                       [&task](double fraction) {
                         if (task.stop.stop_requested()) return false;
                         task.report("Writing", fraction);
                         return true;
                       });
  task.check();
  if (!whole->good()) cannotWrite(file, whole->complaint());
  written.commit();
}

}  // namespace relievo
