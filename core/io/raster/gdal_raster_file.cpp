// SPDX-License-Identifier: BSD-3-Clause
// The one file through which rasters are written by GDAL, and the registry of coordinate systems is
// asked. It needs nothing of relievo but declarations, so that it can also be a library of its own
// (gdal_library.cpp).
#include <ogr_spatialref.h>

#include <limits>

#include "core/io/raster/gdal_session.h"
#include "core/io/raster/raster_file.h"

namespace relievo {
namespace {

char** listOf(const std::vector<const char*>& terminated) {
  return const_cast<char**>(terminated.data());
}

int passProgress(double fraction, const char* /*words*/, void* data) {
  const auto& goes_on = *static_cast<const std::function<bool(double)>*>(data);
  return goes_on(fraction) ? 1 : 0;
}

class GdalRasterFile final : public RasterFile {
 public:
  GdalRasterFile(const std::filesystem::path& file, const RasterSpec& spec)
      : size_(spec.size), type_(spec.is_float ? GDT_Float32 : GDT_Byte) {
    attempt([&] {
      registerRasterDrivers();
      constexpr GIntBig kLittle = 64LL << 20U;
      if (spec.passes_once) GDALSetCacheMax64(kLittle);  // By default a twentieth of the memory.
      // Whoever writes gigabytes has looked for room; GDAL looks at the folder of the name that it
      // is given, which may be one of /proc.
      std::optional<CPLConfigOptionSetter> asked;
      if (spec.passes_once) asked.emplace("CHECK_DISK_FREE_SPACE", "NO", false);
      return create(file, spec) && describe(spec);
    });
  }
  ~GdalRasterFile() override {
    const GdalErrors silent;
    dataset_.reset();
  }

  void setEntries(const RasterEntries& entries) override {
    attempt([&] { return keepEntries(entries); });
  }
  void writeRows(int band, int first, int rows, const void* cells, std::ptrdiff_t step) override {
    attempt([&] {
      GDALRasterBand* to = dataset_->GetRasterBand(band == kMask ? 1 : band);
      if (band == kMask) to = to->GetMaskBand();
      return to->RasterIO(GF_Write, 0, first, size_.cols, rows, const_cast<void*>(cells),
                          size_.cols, rows, band == kMask ? GDT_Byte : type_, 0, step,
                          nullptr) == CE_None;
    });
  }
  void writePixels(int first, int rows, const void* pixels) override {
    const int bands = dataset_ ? dataset_->GetRasterCount() : 0;
    attempt([&] {
      return dataset_->RasterIO(GF_Write, 0, first, size_.cols, rows, const_cast<void*>(pixels),
                                size_.cols, rows, GDT_Byte, bands, nullptr, bands,
                                static_cast<GSpacing>(bands) * size_.cols, 1, nullptr) == CE_None;
    });
  }
  void writeTile(int band, int col, int row, const void* cells) override {
    attempt([&] {
      return dataset_->GetRasterBand(band)->WriteBlock(col, row, const_cast<void*>(cells)) ==
             CE_None;
    });
  }
  void addMask() override {
    attempt([&] {
      const CPLConfigOptionSetter inside("GDAL_TIFF_INTERNAL_MASK", "YES", false);
      return dataset_->CreateMaskBand(GMF_PER_DATASET) == CE_None;
    });
  }
  void copyForClouds(const std::filesystem::path& file, const std::vector<const char*>& options,
                     const std::function<bool(double)>& goes_on) override {
    attempt([&] {
      std::vector<const char*> terminated = options;
      terminated.push_back(nullptr);
      Dataset made(GetGDALDriverManager()->GetDriverByName("COG")->CreateCopy(
          file.c_str(), dataset_.get(), 0, listOf(terminated), passProgress,
          const_cast<std::function<bool(double)>*>(&goes_on)));
      return made != nullptr;
    });
  }
  void close() override {
    const GdalErrors errors;
    dataset_.reset();
    keep(errors);
  }

 private:
  template <class Step>
  void attempt(const Step& step) {
    if (!good_) return;
    const GdalErrors errors;
    good_ = step();
    keep(errors);
  }
  void keep(const GdalErrors& errors) {
    if (!errors.any()) return;
    if (complaint_.empty()) complaint_ = errors.first();
    good_ = false;
  }
  bool create(const std::filesystem::path& file, const RasterSpec& spec) {
    std::vector<const char*> terminated = spec.options;
    terminated.push_back(nullptr);
    const char* const driver = file.empty() ? "MEM" : "GTiff";
    dataset_.reset(GetGDALDriverManager()->GetDriverByName(driver)->Create(
        file.c_str(), size_.cols, size_.rows, spec.bands, type_, listOf(terminated)));
    return dataset_ != nullptr;
  }
  bool describe(const RasterSpec& spec) {
    auto transform = spec.transform;
    dataset_->SetGeoTransform(transform.data());
    if (!spec.projection.empty()) dataset_->SetProjection(spec.projection.c_str());
    if (!spec.entries.empty()) keepEntries(spec.entries);
    GDALRasterBand& first = *dataset_->GetRasterBand(1);
    if (!spec.unit.empty()) first.SetUnitType(spec.unit.c_str());
    if (spec.nan_is_nodata) first.SetNoDataValue(std::numeric_limits<double>::quiet_NaN());
    return true;
  }
  bool keepEntries(const RasterEntries& entries) {
    CPLStringList list;
    for (const auto& [name, text] : entries) list.SetNameValue(name.c_str(), text.c_str());
    dataset_->SetMetadata(list.List());
    return true;
  }

  GridSize size_;
  GDALDataType type_;
  Dataset dataset_;
};

}  // namespace

std::unique_ptr<RasterFile> createRasterFile(const std::filesystem::path& file,
                                             const RasterSpec& spec) {
  return std::make_unique<GdalRasterFile>(file, spec);
}

std::optional<SystemFacts> systemFacts(int epsg) {
  const GdalErrors silent;
  OGRSpatialReference reference;
  if (reference.importFromEPSG(epsg) != OGRERR_NONE) return std::nullopt;
  return SystemFacts{reference.IsGeographic() != 0, reference.GetLinearUnits()};
}

std::optional<StatedSystem> statedSystem(const std::string& stated) {
  const GdalErrors silent;
  OGRSpatialReference system;
  // Nothing but these: GDAL's own reading of any text opens files and addresses, too.
  const bool is_code = stated.starts_with("EPSG:") &&
                       stated.find_first_not_of("0123456789+", 5) == std::string::npos;
  if (is_code ? system.SetFromUserInput(stated.c_str()) != OGRERR_NONE
              : system.importFromWkt(stated.c_str()) != OGRERR_NONE) {
    return std::nullopt;
  }
  if (system.IsProjected() == 0 && system.IsGeographic() == 0) return std::nullopt;
  StatedSystem found;
  found.facts = {.is_geographic = system.IsGeographic() != 0, .metres = system.GetLinearUnits()};
  if (system.IsCompound() != 0 &&
      system.GetTargetLinearUnits("VERT_CS", nullptr) != found.facts.metres) {
    system.StripVertical();
    found.left_heights = true;
  }
  char* text = nullptr;
  if (system.exportToWkt(&text) == OGRERR_NONE) found.text = text;
  CPLFree(text);
  return found.text.empty() ? std::nullopt : std::optional<StatedSystem>(std::move(found));
}

std::string gdalVersion() {
  return GDALVersionInfo("RELEASE_NAME");
}

void prepareRasterFiles() {
  registerRasterDrivers();
}

}  // namespace relievo
