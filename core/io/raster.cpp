// SPDX-License-Identifier: BSD-3-Clause
#include "core/io/raster.h"

#include <ogr_spatialref.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

#include "core/base/error.h"
#include "core/base/unit.h"
#include "core/io/ascii_grid.h"
#include "core/io/file_check.h"
#include "core/io/format.h"
#include "core/io/gdal_session.h"
#include "core/io/number_text.h"
#include "core/io/planted_fault.h"
#include "core/io/unit_text.h"

namespace relievo {
namespace {

constexpr std::uint64_t kMaxCells = 400'000'000;
constexpr double kSquareTolerance = 1e-6;  ///< Relative; the header's promise about pixels.
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& reason) {
  throw FileError("Cannot read " + shownName(file) + ": " + printable(reason));
}

Dataset openRaster(const std::filesystem::path& file, const RasterKind& kind,
                   const GdalErrors& errors) {
  registerRasterDrivers();
  const char* const drivers[] = {kind.driver, nullptr};
  Dataset dataset(GDALDataset::Open(file.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, drivers));
  if (!dataset) {
    refuse(file, "it is not a readable " + std::string(kind.name) +
                     (errors.any() ? " (" + errors.first() + ")" : std::string()) +
                     ". Export it again as GeoTIFF.");
  }
  return dataset;
}

/// Place and pitch of the samples; heights may still be in another order.
struct Placement {
  double pixel = 1;
  FilePoint first;
  bool rows_from_top = true;
};

Placement placementOf(GDALDataset& dataset, RasterMap& raster) {
  const std::filesystem::path& file = raster.info.file;
  std::array<double, 6> g{0, 1, 0, static_cast<double>(raster.size.rows), 0, -1};
  if (dataset.GetGeoTransform(g.data()) != CE_None) {
    g = {0, 1, 0, static_cast<double>(raster.size.rows), 0, -1};
    raster.info.warnings.emplace_back(
        "The raster has no georeference; one pixel was taken as one unit.");
  }
  if (!std::all_of(g.begin(), g.end(), [](double v) { return std::isfinite(v); }) || g[1] == 0) {
    refuse(file, "its georeference holds no usable numbers. Write it again with gdal_translate.");
  }
  const double pixel = std::abs(g[1]);
  if (std::abs(g[2]) > kSquareTolerance * pixel || std::abs(g[4]) > kSquareTolerance * pixel ||
      g[1] < 0) {
    refuse(file,
           "its rows do not run from west to east; it is rotated or mirrored. "
           "Make it north-up with gdalwarp.");
  }
  if (std::abs(std::abs(g[5]) - pixel) > kSquareTolerance * pixel) {
    refuse(file, "its pixels are not square (" + roundTripText(std::array{pixel, std::abs(g[5])}) +
                     "). Resample it with gdalwarp -tr.");
  }
  Placement placement;
  placement.pixel = pixel;
  placement.rows_from_top = g[5] < 0;
  const double first_line = g[3] + 0.5 * g[5];
  const double lowest =
      placement.rows_from_top ? first_line + (raster.size.rows - 1) * g[5] : first_line;
  placement.first = {g[0] + 0.5 * g[1], lowest, 0};
  return placement;
}

/// Horizontal unit into info.unit. @return  factor from stored heights to that unit.
double readUnits(GDALDataset& dataset, ScanInfo& info) {
  const OGRSpatialReference* srs = dataset.GetSpatialRef();
  if (srs == nullptr || srs->IsEmpty()) return 1;
  if (srs->IsGeographic()) {
    refuse(info.file,
           "its pixels are measured in degrees. Reproject it to metres, for example "
           "gdalwarp -t_srs EPSG:UTM-ZONE.");
  }
  if (!srs->IsProjected() && !srs->IsLocal()) return 1;
  const double metres = srs->GetLinearUnits(nullptr);
  info.unit = unitOfMetres(metres);
  if (!info.unit) {
    info.warnings.push_back("The raster's unit of " + roundTripText(std::array{metres}) +
                            " m is not known here; state it with --unit.");
    return 1;
  }
  std::optional<LengthUnit> vertical;
  if (srs->IsVertical()) vertical = unitOfMetres(srs->GetTargetLinearUnits("VERT_CS", nullptr));
  if (!vertical) vertical = unitOfName(dataset.GetRasterBand(1)->GetUnitType());
  if (!vertical) {
    info.warnings.push_back("The raster states no unit for its heights; they were taken to be in " +
                            std::string(name(*info.unit)) + " like its coordinates.");
    return 1;
  }
  if (*vertical == *info.unit) return 1;
  info.warnings.push_back("Heights in " + std::string(name(*vertical)) + " were converted to " +
                          std::string(name(*info.unit)) + ", the unit of the coordinates.");
  return mmPer(*vertical) / mmPer(*info.unit);
}

/// Well-known text; empty if the raster has none.
std::string projectionOf(GDALDataset& dataset) {
  const char* const text = dataset.GetProjectionRef();
  return text == nullptr ? std::string() : std::string(text);
}

void checkBand(GDALRasterBand& band, const std::filesystem::path& file) {
  if (GDALDataTypeIsComplex(band.GetRasterDataType()) != 0) {
    refuse(file, "its cells are complex numbers, not heights. Choose a height raster.");
  }
  const GDALColorInterp colour = band.GetColorInterpretation();
  if (colour == GCI_RedBand || colour == GCI_PaletteIndex) {
    refuse(file,
           "it is a colour picture, not a height raster. Choose the raster with one band of "
           "heights.");
  }
}

/// Stored number to height: value * scale + offset in the unit of the coordinates.
struct HeightRule {
  double scale = 1, offset = 0;
};

HeightRule heightRule(GDALRasterBand& band, double unit_factor) {
  HeightRule rule;
  int stated = 0;
  const double scale = band.GetScale(&stated);
  if (stated != 0 && std::isfinite(scale) && scale != 0) rule.scale = scale;
  const double offset = band.GetOffset(&stated);
  if (stated != 0 && std::isfinite(offset)) rule.offset = offset;
  rule.scale *= unit_factor;
  rule.offset *= unit_factor;
  return rule;
}

void readCells(GDALRasterBand& band, const Placement& placement, const HeightRule& rule,
               const GdalErrors& errors, RasterMap& raster) {
  const auto cols = static_cast<std::size_t>(raster.size.cols);
  plantedFault(raster.size.rows == 7);
  raster.values.assign(raster.size.count(), kNaN);
  raster.valid.assign(raster.size.count(), false);
  std::vector<double> line(cols);
  std::vector<std::uint8_t> mask(cols);
  GDALRasterBand& mask_band = *band.GetMaskBand();
  for (int file_row = 0; file_row < raster.size.rows; ++file_row) {
    if (band.RasterIO(GF_Read, 0, file_row, raster.size.cols, 1, line.data(), raster.size.cols, 1,
                      GDT_Float64, 0, 0, nullptr) != CE_None ||
        mask_band.RasterIO(GF_Read, 0, file_row, raster.size.cols, 1, mask.data(), raster.size.cols,
                           1, GDT_Byte, 0, 0, nullptr) != CE_None) {
      refuse(raster.info.file, "row " + std::to_string(file_row) + " is damaged or missing (" +
                                   errors.first() + "). Copy or export it again.");
    }
    const int row = placement.rows_from_top ? raster.size.rows - 1 - file_row : file_row;
    const std::size_t start = raster.size.index({0, row});
    for (std::size_t col = 0; col < cols; ++col) {
      const auto height = static_cast<float>(line[col] * rule.scale + rule.offset);
      if (mask[col] == 0 || !std::isfinite(height)) continue;
      raster.values[start + col] = height;
      raster.valid[start + col] = true;
    }
  }
}

void summarize(RasterMap& raster) {
  double lowest = std::numeric_limits<double>::infinity();
  double highest = -lowest;
  std::uint64_t valid = 0;
  for (std::size_t i = 0; i < raster.values.size(); ++i) {
    if (!raster.valid[i]) continue;
    ++valid;
    lowest = std::min(lowest, static_cast<double>(raster.values[i]));
    highest = std::max(highest, static_cast<double>(raster.values[i]));
  }
  raster.info.points = raster.size.count();
  raster.info.finite_points = valid;
  if (valid == 0) {
    refuse(raster.info.file, "none of its " + grouped(raster.info.points) +
                                 " cells holds a height. Choose another raster.");
  }
  raster.info.bounds =
      FileBounds{{raster.first.x, raster.first.y, lowest},
                 {raster.first.x + (raster.size.cols - 1) * raster.pixel,
                  raster.first.y + (raster.size.rows - 1) * raster.pixel, highest}};
}

/// The exact frame of an own map, unless another program moved or cut the raster since.
void restoreFrame(GDALDataset& dataset, RasterMap& raster) {
  const auto frame = parseNumbers<3>(dataset.GetMetadataItem("RELIEVO_FRAME"));
  if (!frame) return;
  const auto [x, y, spacing] = *frame;
  const double tolerance = kSquareTolerance * raster.pixel;
  if (std::abs(x - raster.first.x) > tolerance || std::abs(y - raster.first.y) > tolerance ||
      std::abs(spacing - raster.pixel) * std::max(raster.size.cols, raster.size.rows) > tolerance) {
    return;
  }
  raster.first = {x, y, 0};
  raster.pixel = spacing;
}

/// Origins beside an own map; empty with a warning if they do not belong to it.
std::vector<Origin> readOrigins(const RasterMap& raster, std::vector<std::string>& warnings) {
  const std::filesystem::path file = originFileOf(raster.info.file);
  std::error_code missing;
  if (!std::filesystem::exists(file, missing)) return {};
  const GdalErrors errors;
  const char* const drivers[] = {"GTiff", nullptr};
  const Dataset dataset(
      GDALDataset::Open(file.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, drivers));
  const auto ignore = [&](const std::string& reason) {
    warnings.push_back(shownName(file) + " " + reason + " and was left aside.");
    return std::vector<Origin>{};
  };
  if (!dataset) return ignore("cannot be read");
  if (dataset->GetRasterXSize() != raster.size.cols ||
      dataset->GetRasterYSize() != raster.size.rows || dataset->GetRasterCount() < 1) {
    return ignore("has another size than the map");
  }
  std::vector<std::uint8_t> codes(raster.size.count());
  const auto stride = static_cast<GSpacing>(raster.size.cols);
  if (dataset->GetRasterBand(1)->RasterIO(
          GF_Read, 0, 0, raster.size.cols, raster.size.rows,
          codes.data() + raster.size.index({0, raster.size.rows - 1}), raster.size.cols,
          raster.size.rows, GDT_Byte, 1, -stride, nullptr) != CE_None) {
    return ignore("cannot be read");
  }
  std::vector<Origin> origins(codes.size());
  for (std::size_t i = 0; i < codes.size(); ++i) {
    const bool outside = codes[i] == static_cast<std::uint8_t>(Origin::outside);
    if (codes[i] >= kOriginCount || outside == raster.valid[i]) {
      return ignore("does not fit the map");
    }
    origins[i] = static_cast<Origin>(codes[i]);
  }
  return origins;
}

void readOwnMap(GDALDataset& dataset, RasterMap& raster) {
  const char* content = dataset.GetMetadataItem("RELIEVO_CONTENT");
  if (content != nullptr && std::string_view(content) == kOriginContent) {
    refuse(raster.info.file,
           "it holds the origins of a map's cells, not heights. Open the map beside it.");
  }
  const char* unit = dataset.GetMetadataItem("RELIEVO_UNIT");
  const char* matrix = dataset.GetMetadataItem("RELIEVO_VIEW_FROM_FILE");
  if (unit == nullptr || matrix == nullptr) return;
  if (std::string_view(unit) == kPointsUnit) return;  // Counts of a map's points, not heights.
  const auto numbers = parseNumbers<16>(matrix);
  if (!numbers || std::string_view(unit) != "mm") {
    refuse(raster.info.file,
           "its RELIEVO_ entries were changed and make no sense. Write the map again.");
  }
  raster.is_own_map = true;
  raster.info.unit = LengthUnit::mm;
  raster.view_from_file = ViewFromFile{*numbers};
  restoreFrame(dataset, raster);
}

}  // namespace

RasterMap readRaster(const std::filesystem::path& file) {
  const std::uint64_t file_bytes = checkedFileSize(file);
  const RasterKind kind =
      rasterKindOf(findFormat(readHead(file, kSniffedBytes), file, file_bytes).format);
  const GdalErrors errors;
  const Dataset dataset = openRaster(file, kind, errors);
  RasterMap raster;
  raster.info.file = file;
  raster.size = {dataset->GetRasterXSize(), dataset->GetRasterYSize()};
  if (dataset->GetRasterCount() < 1 || raster.size.cols < 2 || raster.size.rows < 2) {
    refuse(file, "it has " + std::to_string(raster.size.cols) + " x " +
                     std::to_string(raster.size.rows) +
                     " cells; at least 2 x 2 are needed. Choose a larger raster.");
  }
  if (raster.size.count() > kMaxCells) {
    refuse(file, "it has " + grouped(raster.size.count()) + " cells, more than the limit of " +
                     grouped(kMaxCells) + ". Cut or thin it with gdal_translate.");
  }
  if (kind.driver == std::string_view("AAIGrid")) checkAsciiGridCells(file, raster.size.count());
  GDALRasterBand& band = *dataset->GetRasterBand(1);
  checkBand(band, file);
  if (dataset->GetRasterCount() > 1) {
    raster.info.warnings.push_back("The raster has " + std::to_string(dataset->GetRasterCount()) +
                                   " bands; the first was read as heights.");
  }
  raster.projection = projectionOf(*dataset);
  raster.info.format = std::string(kind.name) + " " + GDALGetDataTypeName(band.GetRasterDataType());
  const bool own = dataset->GetMetadataItem("RELIEVO_VIEW_FROM_FILE") != nullptr;
  const double unit_factor = own ? 1 : readUnits(*dataset, raster.info);
  const Placement placement = placementOf(*dataset, raster);
  raster.pixel = placement.pixel;
  raster.first = placement.first;
  readOwnMap(*dataset, raster);
  readCells(band, placement, heightRule(band, unit_factor), errors, raster);
  summarize(raster);
  if (raster.is_own_map) raster.origins = readOrigins(raster, raster.info.warnings);
  return raster;
}

std::optional<std::string> rasterState(const std::filesystem::path& file) {
  const GdalErrors errors;
  const Dataset dataset = openRaster(file, {.driver = "GTiff", .name = "TIFF"}, errors);
  const char* state = dataset->GetMetadataItem(kDescriptionTag);
  if (state == nullptr) return std::nullopt;
  return state;
}

}  // namespace relievo
