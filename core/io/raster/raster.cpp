// SPDX-License-Identifier: BSD-3-Clause
#include "core/io/raster/raster.h"

#include <ogr_spatialref.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

#include "core/base/failure.h"
#include "core/base/unit.h"
#include "core/io/file_check.h"
#include "core/io/format.h"
#include "core/io/formats/number_text.h"
#include "core/io/formats/unit_text.h"
#include "core/io/raster/ascii_grid.h"
#include "core/io/raster/colour_rows.h"
#include "core/io/raster/gdal_session.h"
#include "core/io/raster/map_file.h"
#include "core/io/raster/tiff_head.h"
#include "core/io/read_scan.h"
#include "core/io/worker/planted_fault.h"
#include "core/io/worker/reader_guard.h"
#include "core/message/catalogue.h"

namespace relievo {
namespace {

constexpr std::uint64_t kMaxCells = 400'000'000;
constexpr std::uint64_t kMaxBlockBytes = std::uint64_t{1} << 30U;
constexpr double kSquareTolerance = 1e-6;  ///< Relative; the header's promise about pixels.
Dataset openRaster(const std::filesystem::path& file, const RasterKind& kind,
                   const GdalErrors& errors) {
  requireReadersAllowed("openRaster");
  registerRasterDrivers();
  const std::uint64_t metadata = largestTiffMetadata(file);
  if (metadata > kMostTiffMetadata) {
    throwReadError(
        file, said<MessageId::refused_raster_metadata>(CountArgument::grouped(metadata),
                                                       CountArgument::grouped(kMostTiffMetadata)));
  }
  const char* const drivers[] = {kind.driver, nullptr};
  Dataset dataset(GDALDataset::Open(file.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, drivers));
  if (!dataset) {
    if (!errors.any()) throwReadError(file, said<MessageId::refused_raster>(kind.name));
    throwReadError(file,
                   said<MessageId::refused_raster_because>(kind.name, printable(errors.first())));
  }
  return dataset;
}

/// Place and pitch of the samples; heights may still be in another order.
struct Placement {
  double pixel = 1;
  FilePoint first;
  bool rows_from_top = true;
};

Placement placementOf(GDALDataset& dataset, RasterHead& raster) {
  const std::filesystem::path& file = raster.info.file;
  std::array<double, 6> g{0, 1, 0, static_cast<double>(raster.size.rows), 0, -1};
  if (dataset.GetGeoTransform(g.data()) != CE_None) {
    g = {0, 1, 0, static_cast<double>(raster.size.rows), 0, -1};
    raster.is_placed = false;
    raster.info.warnings.push_back(said<MessageId::raster_without_georeference>());
  }
  if (!std::all_of(g.begin(), g.end(), [](double v) { return std::isfinite(v); }) || g[1] == 0) {
    throwReadError(file, said<MessageId::refused_georeference>());
  }
  const double pixel = std::abs(g[1]);
  if (std::abs(g[2]) > kSquareTolerance * pixel || std::abs(g[4]) > kSquareTolerance * pixel ||
      g[1] < 0) {
    throwReadError(file, said<MessageId::refused_rotated_raster>());
  }
  if (std::abs(std::abs(g[5]) - pixel) > kSquareTolerance * pixel) {
    throwReadError(file, said<MessageId::refused_pixels_not_square>(
                             roundTripText(std::array{pixel, std::abs(g[5])})));
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

/// "NAVD88 height (ftUS)" without what is in the last parentheses.
std::string withoutUnit(const std::string& name) {
  const std::size_t at = name.ends_with(')') ? name.rfind(" (") : std::string::npos;
  return at == std::string::npos ? name : name.substr(0, at);
}

/// The same system, its heights above the same datum, but in another unit. Codes of registers
/// name a unit as well, so that they go. Empty: it cannot be said so.
std::string withHeightsIn(const OGRSpatialReference& system, LengthUnit unit) {
  OGRSpatialReference changed(system);
  OGR_SRSNode* const vertical = changed.GetAttrNode("VERT_CS");
  OGR_SRSNode* const all = changed.GetRoot();
  if (vertical == nullptr || all == nullptr) return {};
  for (OGR_SRSNode* node : {vertical, all}) {
    if (const int code = node->FindChild("AUTHORITY"); code >= 0) node->DestroyChild(code);
    if (node->GetChildCount() > 0) {
      OGR_SRSNode* const name = node->GetChild(0);
      name->SetValue(withoutUnit(name->GetValue()).c_str());
    }
  }
  const double metres = mmPer(unit) / 1000;
  changed.SetTargetLinearUnits("VERT_CS", std::string(projectionName(unit)).c_str(), metres);
  char* text = nullptr;
  if (changed.exportToWkt(&text) != OGRERR_NONE) return {};
  const std::string wkt = text;
  CPLFree(text);
  const OGRSpatialReference back(wkt.c_str());
  const bool holds =
      back.IsCompound() != 0 && unitOfMetres(back.GetTargetLinearUnits("VERT_CS", nullptr)) == unit;
  return holds ? wkt : std::string();
}

/// What the reference system says of heights must be true of those that are handed on.
void sayHeightsIn(const OGRSpatialReference& system, LengthUnit unit, RasterHead& raster) {
  if (system.IsCompound() == 0) return;
  raster.projection = withHeightsIn(system, unit);
  if (!raster.projection.empty()) return;
  OGRSpatialReference flat(system);
  flat.StripVertical();
  char* text = nullptr;
  if (flat.exportToWkt(&text) == OGRERR_NONE) raster.projection = text;
  CPLFree(text);
  raster.info.warnings.push_back(said<MessageId::raster_height_system_left_out>());
}

/// Horizontal unit into info.unit. @return  factor from stored heights to that unit.
double readUnits(GDALDataset& dataset, RasterHead& raster) {
  ScanInfo& info = raster.info;
  const OGRSpatialReference* srs = dataset.GetSpatialRef();
  if (srs == nullptr || srs->IsEmpty()) return 1;
  if (srs->IsGeographic()) {
    throw failure<MessageId::raster_in_degrees>(shownName(info.file));
  }
  if (!srs->IsProjected() && !srs->IsLocal()) return 1;
  const double metres = srs->GetLinearUnits(nullptr);
  info.unit = unitOfMetres(metres);
  if (!info.unit) {
    info.warnings.push_back(
        said<MessageId::raster_unit_unknown>(roundTripText(std::array{metres})));
    return 1;
  }
  std::optional<LengthUnit> vertical;
  if (srs->IsVertical()) vertical = unitOfMetres(srs->GetTargetLinearUnits("VERT_CS", nullptr));
  if (!vertical) vertical = unitOfName(dataset.GetRasterBand(1)->GetUnitType());
  if (!vertical) {
    // Whoever gives a unit gives it for both.
    info.warnings.push_back(said<MessageId::raster_heights_without_unit>());
    return 1;
  }
  if (*vertical == *info.unit) return 1;
  plantedFault(*vertical == LengthUnit::ft);
  info.warnings.push_back(
      said<MessageId::raster_heights_converted>(name(*vertical), name(*info.unit)));
  sayHeightsIn(*srs, *info.unit, raster);
  return mmPer(*vertical) / mmPer(*info.unit);
}

/// Well-known text; empty if the raster has none.
std::string projectionOf(GDALDataset& dataset) {
  const char* const text = dataset.GetProjectionRef();
  return text == nullptr ? std::string() : std::string(text);
}

void checkBand(GDALRasterBand& band, const std::filesystem::path& file) {
  if (GDALDataTypeIsComplex(band.GetRasterDataType()) != 0) {
    throwReadError(file, said<MessageId::refused_complex_cells>());
  }
  const GDALColorInterp colour = band.GetColorInterpretation();
  if (colour == GCI_RedBand || colour == GCI_PaletteIndex) {
    throw failure<MessageId::raster_is_a_colour_picture>(shownName(file));
  }
}

/// GDAL reads strips and tiles whole, and of all bands where these alternate cell by cell: a few
/// bytes of file can ask for gigabytes.
void checkBlocks(GDALDataset& dataset, GDALRasterBand& band, const std::filesystem::path& file) {
  int cols = 0, rows = 0;
  band.GetBlockSize(&cols, &rows);
  const char* const interleave = dataset.GetMetadataItem("INTERLEAVE", "IMAGE_STRUCTURE");
  const bool alternate = interleave != nullptr && std::string_view(interleave) == "PIXEL";
  const double bytes = static_cast<double>(cols) * rows *
                       (alternate ? dataset.GetRasterCount() : 1) *
                       GDALGetDataTypeSizeBytes(band.GetRasterDataType());
  if (bytes <= static_cast<double>(kMaxBlockBytes)) return;
  throwReadError(file, said<MessageId::refused_raster_strips>(
                           CountArgument::grouped(static_cast<std::uint64_t>(bytes / 1e6))));
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

/// The exact frame of an own map, unless another program moved or cut the raster since.
void restoreFrame(GDALDataset& dataset, RasterHead& raster) {
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

std::string_view factOf(GDALDataset& dataset, const char* name) {
  const char* const text = dataset.GetMetadataItem(name);
  return text == nullptr ? std::string_view() : std::string_view(text);
}

/// The origins beside an own map, row by row; none, with a warning, if they do not belong to it.
class OriginRows {
 public:
  OriginRows(GDALDataset& map, RasterHead& raster)
      : raster_(raster), file_(originFileOf(raster.info.file)) {
    std::error_code missing;
    if (!raster.is_own_map || !std::filesystem::exists(file_, missing)) return;
    const char* const drivers[] = {"GTiff", nullptr};
    dataset_.reset(GDALDataset::Open(file_.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, drivers));
    if (!dataset_) {
      drop<MessageId::companion_unreadable>();
    } else if (dataset_->GetRasterXSize() != raster.size.cols ||
               dataset_->GetRasterYSize() != raster.size.rows || dataset_->GetRasterCount() < 1) {
      drop<MessageId::companion_of_another_size>();
    } else if (!belongsTo(map)) {
      drop<MessageId::companion_of_another_map>();
    }
    codes_.resize(static_cast<std::size_t>(raster.size.cols));
    origins_.resize(codes_.size());
  }

  bool any() const noexcept { return dataset_ != nullptr; }

  /// @return  null if there are none, or no longer
  const CellStatus* row(int row, const std::vector<float>& heights) {
    if (!dataset_) return nullptr;
    const GridSize size = raster_.size;
    if (dataset_->GetRasterBand(1)->RasterIO(GF_Read, 0, size.rows - 1 - row, size.cols, 1,
                                             codes_.data(), size.cols, 1, GDT_Byte, 0, 0,
                                             nullptr) != CE_None) {
      drop<MessageId::companion_unreadable>();
      return nullptr;
    }
    for (std::size_t col = 0; col < codes_.size(); ++col) {
      const bool outside = codes_[col] == static_cast<std::uint8_t>(CellStatus::outside);
      if (codes_[col] >= kOriginCount || outside != std::isnan(heights[col])) {
        drop<MessageId::companion_does_not_fit>();
        return nullptr;
      }
      origins_[col] = static_cast<CellStatus>(codes_[col]);
    }
    return origins_.data();
  }

 private:
  /// Origins that fit by chance, or that a killed program left, would tell what is not so.
  bool belongsTo(GDALDataset& map) const {
    if (factOf(*dataset_, kContentFact) != kOriginContent) return false;
    const bool none_says = raster_.set.empty() && factOf(*dataset_, kSetFact).empty();
    if (!none_says) return factOf(*dataset_, kSetFact) == raster_.set;
    // Of earlier builds.
    const std::array<const char*, 3> same{"RELIEVO_VIEW_FROM_FILE", "RELIEVO_FRAME",
                                          kDescriptionTag};
    return std::all_of(same.begin(), same.end(), [&](const char* fact) {
      return factOf(*dataset_, fact) == factOf(map, fact);
    });
  }

  template <MessageId why>
  void drop() {
    dataset_.reset();
    raster_.info.warnings.push_back(said<why>(shownName(file_)));
  }

  RasterHead& raster_;
  std::filesystem::path file_;
  Dataset dataset_;
  std::vector<std::uint8_t> codes_;
  std::vector<CellStatus> origins_;
};

/// One row of the file after the other as heights.
class HeightRows {
 public:
  HeightRows(GDALRasterBand& band, const HeightRule& rule, int cols)
      : band_(band),
        mask_band_(*band.GetMaskBand()),
        all_valid_(band.GetMaskFlags() == GMF_ALL_VALID),
        rule_(rule),
        line_(static_cast<std::size_t>(cols)),
        mask_(line_.size(), 1),
        heights_(line_.size()) {}

  /// @return  false if the row cannot be read
  bool read(int file_row) {
    const int cols = static_cast<int>(line_.size());
    if (band_.RasterIO(GF_Read, 0, file_row, cols, 1, line_.data(), cols, 1, GDT_Float64, 0, 0,
                       nullptr) != CE_None) {
      return false;
    }
    if (!all_valid_ && mask_band_.RasterIO(GF_Read, 0, file_row, cols, 1, mask_.data(), cols, 1,
                                           GDT_Byte, 0, 0, nullptr) != CE_None) {
      return false;
    }
    for (std::size_t col = 0; col < line_.size(); ++col) {
      const auto height = static_cast<float>(line_[col] * rule_.scale + rule_.offset);
      heights_[col] = mask_[col] == 0 || !std::isfinite(height) ? kNoHeight : height;
    }
    return true;
  }
  const std::vector<float>& heights() const noexcept { return heights_; }

 private:
  GDALRasterBand& band_;
  GDALRasterBand& mask_band_;
  bool all_valid_;
  HeightRule rule_;
  std::vector<double> line_;
  std::vector<std::uint8_t> mask_;
  std::vector<float> heights_;
};

/// What the heights tell of the raster.
class HeightSummary {
 public:
  void add(const std::vector<float>& heights) {
    for (const float height : heights) {
      if (std::isnan(height)) continue;
      ++valid_;
      lowest_ = std::min(lowest_, height);
      highest_ = std::max(highest_, height);
    }
  }
  void into(RasterHead& raster) const {
    raster.info.finite_points = valid_;
    if (valid_ == 0) {
      throwReadError(raster.info.file, said<MessageId::refused_raster_without_heights>(
                                           CountArgument::grouped(raster.info.points)));
    }
    raster.info.bounds =
        FileBounds{{raster.first.x, raster.first.y, lowest_},
                   {raster.first.x + (raster.size.cols - 1) * raster.pixel,
                    raster.first.y + (raster.size.rows - 1) * raster.pixel, highest_}};
  }

 private:
  std::uint64_t valid_ = 0;
  float lowest_ = std::numeric_limits<float>::infinity();
  float highest_ = -std::numeric_limits<float>::infinity();
};

RasterEnd passRows(GDALDataset& dataset, HeightRows& rows, bool rows_from_top,
                   const GdalErrors& errors, RasterHead& raster, const RasterSink& sink,
                   const Task& task) {
  const int count = raster.size.rows;
  OriginRows origins(dataset, raster);
  HeightSummary summary;
  sink.begin(raster, origins.any());
  for (int file_row = 0; file_row < count; ++file_row) {
    if (file_row % 16 == 0) {
      task.check();
      task.report("reading heights", static_cast<double>(file_row) / count);
    }
    if (!rows.read(file_row)) {
      throwReadError(raster.info.file,
                     said<MessageId::refused_raster_row>(file_row, printable(errors.first())),
                     said<MessageId::advice_copy_or_export>());
    }
    const int row = rows_from_top ? count - 1 - file_row : file_row;
    summary.add(rows.heights());
    sink.row(row, rows.heights().data(), origins.row(row, rows.heights()));
  }
  summary.into(raster);
  return {.head = raster, .has_origins = origins.any()};
}

void readOwnMap(GDALDataset& dataset, RasterHead& raster) {
  const char* content = dataset.GetMetadataItem("RELIEVO_CONTENT");
  if (content != nullptr && std::string_view(content) == kOriginContent) {
    throwReadError(raster.info.file, said<MessageId::refused_origins>());
  }
  const char* unit = dataset.GetMetadataItem("RELIEVO_UNIT");
  const char* matrix = dataset.GetMetadataItem("RELIEVO_VIEW_FROM_FILE");
  if (unit == nullptr || matrix == nullptr) return;
  if (std::string_view(unit) == kPointsUnit) return;  // Counts of a map's points, not heights.
  const auto numbers = parseNumbers<16>(matrix);
  if (!numbers || std::string_view(unit) != "mm") {
    throwReadError(raster.info.file, said<MessageId::refused_own_entries>(),
                   said<MessageId::advice_write_map_again>());
  }
  raster.is_own_map = true;
  raster.set = factOf(dataset, kSetFact);
  raster.info.unit = LengthUnit::mm;
  raster.view_from_file = ViewFromFile{*numbers};
  restoreFrame(dataset, raster);
}

}  // namespace

RasterEnd readRasterRows(const std::filesystem::path& file, const RasterSink& sink,
                         const Task& task) {
  const std::uint64_t file_bytes = checkedFileSize(file);
  const RasterKind kind =
      rasterKindOf(findFormat(readHead(file, kSniffedBytes), file, file_bytes).format);
  const GdalErrors errors;
  const Dataset dataset = openRaster(file, kind, errors);
  RasterHead raster;
  raster.info.file = file;
  raster.size = {dataset->GetRasterXSize(), dataset->GetRasterYSize()};
  if (dataset->GetRasterCount() < 1 || raster.size.cols < 2 || raster.size.rows < 2) {
    throwReadError(file, said<MessageId::refused_small_raster>(raster.size.cols, raster.size.rows));
  }
  if (raster.size.count() > kMaxCells) {
    throwReadError(
        file, said<MessageId::refused_large_raster>(CountArgument::grouped(raster.size.count()),
                                                    CountArgument::grouped(kMaxCells)));
  }
  if (kind.driver == std::string_view("AAIGrid")) checkAsciiGridCells(file, raster.size.count());
  GDALRasterBand& band = *dataset->GetRasterBand(1);
  checkBlocks(*dataset, band, file);
  if (auto colours = readColourRows(*dataset, raster, sink, task)) return *colours;
  checkBand(band, file);
  if (dataset->GetRasterCount() > 1) {
    raster.info.warnings.push_back(said<MessageId::raster_bands>(dataset->GetRasterCount()));
  }
  raster.projection = projectionOf(*dataset);
  raster.info.format = std::string(kind.name) + " " + GDALGetDataTypeName(band.GetRasterDataType());
  const bool own = dataset->GetMetadataItem("RELIEVO_VIEW_FROM_FILE") != nullptr;
  const double unit_factor = own ? 1 : readUnits(*dataset, raster);
  const Placement placement = placementOf(*dataset, raster);
  raster.pixel = placement.pixel;
  raster.first = placement.first;
  readOwnMap(*dataset, raster);
  raster.info.points = raster.size.count();
  const HeightRule rule = heightRule(band, unit_factor);
  if (GDALDataTypeIsInteger(band.GetRasterDataType()) != 0) {
    raster.info.height_step = std::abs(rule.scale);
  }
  HeightRows rows(band, rule, raster.size.cols);
  return passRows(*dataset, rows, placement.rows_from_top, errors, raster, sink, task);
}

RasterMap readRaster(const std::filesystem::path& file) {
  RasterMap raster;
  GridSize size;
  const RasterSink sink{.begin =
                            [&](const RasterHead& head, bool has_origins) {
                              size = head.size;
                              raster.values.resize(size.count());
                              if (has_origins) raster.origins.resize(size.count());
                            },
                        .row =
                            [&](int row, const float* heights, const CellStatus* origins) {
                              const std::size_t start = size.index({.col = 0, .row = row});
                              std::copy_n(heights, size.cols, raster.values.data() + start);
                              if (origins != nullptr)
                                std::copy_n(origins, size.cols, raster.origins.data() + start);
                            }};
  RasterEnd end = readRasterRows(file, sink, {});
  static_cast<RasterHead&>(raster) = std::move(end.head);
  raster.valid.reserve(raster.values.size());
  for (const float value : raster.values) raster.valid.push_back(!std::isnan(value));
  if (!end.has_origins) raster.origins.clear();
  return raster;
}

}  // namespace relievo
