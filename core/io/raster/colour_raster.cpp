// SPDX-License-Identifier: BSD-3-Clause
#include "core/io/raster/colour_raster.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <system_error>
#include <vector>

#include "core/base/error.h"
#include "core/file/atomic_file.h"
#include "core/file/output_set.h"
#include "core/io/file_check.h"
#include "core/io/formats/number_text.h"
#include "core/io/raster/colour_rows.h"
#include "core/io/raster/gdal_session.h"

namespace relievo {
namespace {

constexpr double kMostSent = 0xFFFFFF;
constexpr int kRowsAtOnce = 256;  // As high as a tile.
constexpr const char* kChecksum = "RELIEVO_HEIGHTS";

std::filesystem::path beside(std::filesystem::path map_file, const char* ending) {
  return map_file.replace_extension(ending);
}

std::string_view contentOf(GDALDataset& dataset) {
  const char* const content = dataset.GetMetadataItem(kContentFact);
  return content == nullptr ? std::string_view() : std::string_view(content);
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

CPLStringList metadataOf(const DepthMap& map, std::string_view content, const std::string& set) {
  std::vector<float> heights = map.heights_mm;
  for (std::size_t i = 0; i < heights.size(); ++i) {
    if (map.origins[i] == Origin::outside) heights[i] = std::numeric_limits<float>::quiet_NaN();
  }
  CPLStringList metadata;
  metadata.SetNameValue(kContentFact, std::string(content).c_str());
  metadata.SetNameValue(kChecksum, std::to_string(heightsChecksum(heights)).c_str());
  if (!set.empty()) metadata.SetNameValue(kSetFact, set.c_str());
  metadata.SetNameValue("RELIEVO_VERSION", RELIEVO_VERSION_STRING);
  metadata.SetNameValue("TIFFTAG_SOFTWARE", "relievo " RELIEVO_VERSION_STRING);
  return metadata;
}

/// @return  false once GDAL complains
template <std::size_t Size>
bool writePixels(GDALDataset& dataset, const std::vector<std::array<std::uint8_t, Size>>& pixels,
                 GridSize size) {
  const auto cols = static_cast<std::size_t>(size.cols);
  std::vector<std::array<std::uint8_t, Size>> block(cols * kRowsAtOnce);
  for (int first = 0; first < size.rows; first += kRowsAtOnce) {
    const int rows = std::min(kRowsAtOnce, size.rows - first);
    for (int k = 0; k < rows; ++k) {  // Files begin at the top, maps at the bottom.
      const auto from = static_cast<std::size_t>(size.rows - 1 - first - k);
      std::copy_n(pixels.data() + from * cols, cols,
                  block.data() + static_cast<std::size_t>(k) * cols);
    }
    constexpr int kBands = static_cast<int>(Size);
    if (dataset.RasterIO(GF_Write, 0, first, size.cols, rows, block.data(), size.cols, rows,
                         GDT_Byte, kBands, nullptr, kBands,
                         static_cast<GSpacing>(kBands) * size.cols, 1, nullptr) != CE_None) {
      return false;
    }
  }
  return true;
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
  const GdalErrors errors;
  registerRasterDrivers();
  const char* const options[] = {"COMPRESS=DEFLATE",
                                 "PREDICTOR=2",
                                 "TILED=YES",
                                 "ALPHA=NON-PREMULTIPLIED",
                                 Size == 4 ? "PHOTOMETRIC=RGB" : "PHOTOMETRIC=MINISBLACK",
                                 "BIGTIFF=IF_SAFER",
                                 nullptr};
  Dataset dataset(GetGDALDriverManager()->GetDriverByName("GTiff")->Create(
      written.path().c_str(), size.cols, size.rows, static_cast<int>(Size), GDT_Byte,
      const_cast<char**>(options)));
  if (!dataset) cannotWrite(file, errors.first());
  const GridFrame& f = map.frame;
  const double s = f.spacing_mm;
  std::array<double, 6> transform{
      f.first_x_mm - 0.5 * s, s, 0, f.first_y_mm + (size.rows - 1) * s + 0.5 * s, 0, -s};
  dataset->SetGeoTransform(transform.data());
  CPLStringList metadata = metadataOf(map, content, set);
  dataset->SetMetadata(metadata.List());
  const bool good = writePixels(*dataset, pixels, size);
  dataset.reset();  // Flushes; a full disk shows itself here at the latest.
  if (!good || errors.any()) cannotWrite(file, errors.first());
  written.commit();
}

constexpr std::string_view kColours = "colours";
constexpr std::string_view kIntensities = "intensities";

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

std::optional<RasterEnd> readColourRows(GDALDataset& dataset, RasterHead head,
                                        const RasterSink& sink, const Task& task) {
  const std::string_view content = contentOf(dataset);
  if (content != kColours && content != kIntensities) return std::nullopt;
  const int bands = content == kColours ? 4 : 2;
  const auto refuse = [&](const std::string& reason) {
    throw FileError("Cannot read " + shownName(head.info.file) + ": " + reason +
                    " Write the map again.");
  };
  if (dataset.GetRasterCount() != bands) {
    refuse("it has not the bands that colours of a map have.");
  }
  const GridSize size = head.size;
  head.info.format =
      std::string(content == kColours ? kColourRasterFormat : kIntensityRasterFormat);
  const char* const checksum = dataset.GetMetadataItem(kChecksum);
  head.projection = checksum == nullptr ? "" : checksum;
  const char* const set = dataset.GetMetadataItem(kSetFact);
  head.set = set == nullptr ? "" : set;
  head.size.cols = 2 * size.cols;
  head.info.points = head.info.finite_points = head.size.count();
  head.info.bounds = FileBounds{{0, 0, 0}, {1, 1, kMostSent}};
  sink.begin(head, false);
  const auto cols = static_cast<std::size_t>(size.cols);
  std::vector<std::uint8_t> pixels(cols * static_cast<std::size_t>(bands));
  std::vector<float> row(2 * cols);
  for (int file_row = 0; file_row < size.rows; ++file_row) {
    if (file_row % 16 == 0) task.check();
    if (dataset.RasterIO(GF_Read, 0, file_row, size.cols, 1, pixels.data(), size.cols, 1, GDT_Byte,
                         bands, nullptr, bands, static_cast<GSpacing>(bands) * size.cols, 1,
                         nullptr) != CE_None) {
      refuse("row " + std::to_string(file_row) + " is damaged or missing.");
    }
    for (std::size_t i = 0; i < cols; ++i) {
      const std::uint8_t* const p = &pixels[i * static_cast<std::size_t>(bands)];
      row[i] = bands == 4 ? static_cast<float>((p[0] << 16) + (p[1] << 8) + p[2])
                          : static_cast<float>(p[0]);
      row[cols + i] = static_cast<float>(p[bands - 1]);
    }
    sink.row(size.rows - 1 - file_row, row.data(), nullptr);
  }
  return RasterEnd{.head = head, .has_origins = false};
}

}  // namespace relievo
