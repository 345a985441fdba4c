// SPDX-License-Identifier: BSD-3-Clause
// Maps and exports as GeoTIFF.
#include <array>
#include <limits>
#include <mutex>
#include <span>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/file/atomic_file.h"
#include "core/file/output_set.h"
#include "core/hash/sha256.h"
#include "core/io/formats/number_text.h"
#include "core/io/raster/export_grid.h"
#include "core/io/raster/gdal_session.h"
#include "core/io/raster/gdal_version.h"
#include "core/io/raster/raster.h"
#include "core/io/raster/tiff_head.h"

namespace relievo {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

/// One band, row 0 of `cells` at the lowest y, which is the last row of the file.
struct BandToWrite {
  GDALDataType type;
  const void* cells;
  std::size_t cell_bytes;
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

/// @return  false once GDAL complains
bool writeRows(GDALRasterBand& band, GridSize size, GDALDataType type, const void* cells,
               std::size_t cell_bytes) {
  const auto* bottom_up = static_cast<const std::uint8_t*>(cells);
  const std::size_t line_bytes = static_cast<std::size_t>(size.cols) * cell_bytes;
  for (int file_row = 0; file_row < size.rows; ++file_row) {
    const auto row = static_cast<std::size_t>(size.rows - 1 - file_row);
    auto* line = const_cast<std::uint8_t*>(bottom_up + row * line_bytes);
    if (band.RasterIO(GF_Write, 0, file_row, size.cols, 1, line, size.cols, 1, type, 0, 0,
                      nullptr) != CE_None) {
      return false;
    }
  }
  return true;
}

void describe(GDALDataset& dataset, const RasterPlace& place, const CPLStringList& metadata) {
  const double s = place.spacing;
  std::array<double, 6> transform{
      place.first_x - 0.5 * s, s, 0, place.first_y + (place.size.rows - 1) * s + 0.5 * s, 0, -s};
  dataset.SetGeoTransform(transform.data());
  if (*place.projection != '\0') dataset.SetProjection(place.projection);
  dataset.SetMetadata(const_cast<char**>(metadata.List()));
  if (!place.unit.empty()) dataset.GetRasterBand(1)->SetUnitType(place.unit.c_str());
}

void writeBand(const std::filesystem::path& file, const std::filesystem::path& shown,
               const RasterPlace& place, const BandToWrite& band, const CPLStringList& metadata) {
  GdalErrors errors;
  registerRasterDrivers();
  const GridSize size = place.size;
  const char* const options[] = {"COMPRESS=DEFLATE", "BIGTIFF=IF_SAFER", "NUM_THREADS=ALL_CPUS",
                                 nullptr};
  Dataset dataset(GetGDALDriverManager()->GetDriverByName("GTiff")->Create(
      file.c_str(), size.cols, size.rows, 1, band.type, const_cast<char**>(options)));
  if (!dataset) cannotWrite(shown, errors.first());
  describe(*dataset, place, metadata);
  GDALRasterBand& cells = *dataset->GetRasterBand(1);
  if (band.type == GDT_Float32) cells.SetNoDataValue(kNaN);
  bool good = writeRows(cells, size, band.type, band.cells, band.cell_bytes);
  if (good && band.mask != nullptr) {
    // Within the file, not as NAME.tif.msk beside it.
    const CPLConfigOptionSetter inside("GDAL_TIFF_INTERNAL_MASK", "YES", false);
    good = dataset->CreateMaskBand(GMF_PER_DATASET) == CE_None &&
           writeRows(*cells.GetMaskBand(), size, GDT_Byte, band.mask->data(), 1);
  }
  dataset.reset();  // Flushes; a full disk shows itself here at the latest.
  if (!good || errors.any()) cannotWrite(shown, errors.first());
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

}  // namespace

std::string gdalVersion() {
  return GDALVersionInfo("RELEASE_NAME");
}

void registerRasterDrivers() {
  static std::once_flag registered;
  std::call_once(registered, [] {
    GDALRegister_GTiff();
    GDALRegister_PNG();
    GDALRegister_AAIGrid();
    GDALRegister_MEM();
    GDALRegister_COG();
  });
}

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
    if (map.origins[i] != Origin::outside) continue;
    mask[i] = 0;
    if (options.outside_as_nan) heights[i] = kNaN;
  }
  CPLStringList metadata;
  metadata.SetNameValue("RELIEVO_UNIT", options.unit.c_str());
  metadata.SetNameValue("RELIEVO_VERSION", RELIEVO_VERSION_STRING);
  metadata.SetNameValue("RELIEVO_VIEW_FROM_FILE", roundTripText(options.view_from_file.m).c_str());
  metadata.SetNameValue(
      "RELIEVO_FRAME",
      roundTripText(std::array{map.frame.first_x_mm, map.frame.first_y_mm, map.frame.spacing_mm})
          .c_str());
  metadata.SetNameValue("TIFFTAG_SOFTWARE", "relievo " RELIEVO_VERSION_STRING);
  if (!options.state.empty()) metadata.SetNameValue(kDescriptionTag, options.state.c_str());
  metadata.SetNameValue(
      kSetFact, options.set.empty() ? setOf(map, {}, options).c_str() : options.set.c_str());
  if (!options.what.empty()) metadata.SetNameValue(kContentFact, options.what.c_str());
  if (options.level) {
    metadata.SetNameValue(kLevelFact, std::to_string(*options.level).c_str());
  }

  const std::filesystem::path origin_name = originFileOf(file);
  if (options.write_origins) requireOwnOrAbsent(origin_name);
  AtomicFile map_file(place);
  writeBand(map_file.path(), file, placeOf(map.frame), {GDT_Float32, heights.data(), sizeof(float)},
            metadata);
  if (options.write_origins) {
    AtomicFile origin_file(set.file(origin_name));
    metadata.SetNameValue(kContentFact, std::string(kOriginContent).c_str());
    writeBand(origin_file.path(), origin_name, placeOf(map.frame), {GDT_Byte, codes.data(), 1},
              metadata);
    origin_file.commit();
  } else if (isOwnTiff(origin_name)) {
    set.removes(origin_name);  // An older map's would lie about this one.
  }
  map_file.commit();
}

namespace {

CPLStringList factsOf(const ExportGrid& grid) {
  CPLStringList metadata;
  metadata.SetNameValue("RELIEVO_VERSION", RELIEVO_VERSION_STRING);
  metadata.SetNameValue("HEIGHT_UNIT", grid.unit.c_str());
  metadata.SetNameValue("TIFFTAG_SOFTWARE", "relievo " RELIEVO_VERSION_STRING);
  if (!grid.state.empty()) metadata.SetNameValue(kDescriptionTag, grid.state.c_str());
  return metadata;
}

RasterPlace placeOf(const ExportGrid& grid) {
  return {grid.size,
          grid.first_x,
          grid.first_y,
          grid.spacing,
          grid.is_view ? kViewSystem : grid.projection.c_str(),
          grid.unit};
}

/// Passes GDAL's progress on and stops it.
int passProgress(double fraction, const char* /*words*/, void* data) {
  const auto& task = *static_cast<const Task*>(data);
  if (task.stop.stop_requested()) return 0;
  task.report("Writing", fraction);
  return 1;
}

}  // namespace

void writeGeoTiff(const std::filesystem::path& file, const ExportGrid& grid) {
  std::vector<float> heights = grid.heights;
  std::vector<std::uint8_t> mask(heights.size(), 255);
  for (std::size_t i = 0; i < heights.size(); ++i) {
    if (grid.holds(i)) continue;
    heights[i] = kNaN;
    mask[i] = 0;
  }
  AtomicFile written(file);
  writeBand(written.path(), file, placeOf(grid),
            {GDT_Float32, heights.data(), sizeof(float), &mask}, factsOf(grid));
  written.commit();
}

void writeCloudGeoTiff(const std::filesystem::path& file, const ExportGrid& grid,
                       const Task& task) {
  GdalErrors errors;
  registerRasterDrivers();
  // The driver writes overviews beside the file before they are in it.
  AtomicFile written(file, TemporaryName::beside);
  // The driver copies what is complete: its first bytes say where everything is.
  Dataset whole(GetGDALDriverManager()->GetDriverByName("MEM")->Create(
      "", grid.size.cols, grid.size.rows, 1, GDT_Float32, nullptr));
  if (!whole) cannotWrite(file, errors.first());
  std::vector<float> heights = grid.heights;
  for (std::size_t i = 0; i < heights.size(); ++i) {
    if (!grid.holds(i)) heights[i] = kNaN;
  }
  describe(*whole, placeOf(grid), factsOf(grid));
  whole->GetRasterBand(1)->SetNoDataValue(kNaN);
  bool good =
      writeRows(*whole->GetRasterBand(1), grid.size, GDT_Float32, heights.data(), sizeof(float));
  std::vector<float>().swap(heights);
  const char* const options[] = {
      "COMPRESS=DEFLATE",   "PREDICTOR=YES",    "BLOCKSIZE=512", "OVERVIEWS=AUTO",
      "RESAMPLING=AVERAGE", "BIGTIFF=IF_SAFER", nullptr};
  Dataset made;
  if (good) {
    made.reset(GetGDALDriverManager()->GetDriverByName("COG")->CreateCopy(
        written.path().c_str(), whole.get(), 0, const_cast<char**>(options), passProgress,
        const_cast<Task*>(&task)));
  }
  task.check();
  good = made != nullptr;
  made.reset();
  if (!good || errors.any()) cannotWrite(file, errors.first());
  written.commit();
}

}  // namespace relievo
