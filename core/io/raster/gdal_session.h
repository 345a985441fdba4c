// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Only for the .cpp files of core/io that call GDAL: what all need of it.
#include <cpl_conv.h>
#include <cpl_error.h>
#include <gdal_priv.h>

#include <memory>
#include <string>
#include <string_view>

namespace relievo {

struct CloseDataset {
  void operator()(GDALDataset* dataset) const { GDALClose(dataset); }
};
using Dataset = std::unique_ptr<GDALDataset, CloseDataset>;

/// Collects what GDAL complains about on this thread while it lives, instead of printing it.
class GdalErrors {
 public:
  GdalErrors() { CPLPushErrorHandlerEx(&GdalErrors::collect, this); }
  ~GdalErrors() { CPLPopErrorHandler(); }
  GdalErrors(const GdalErrors&) = delete;
  GdalErrors& operator=(const GdalErrors&) = delete;

  bool any() const noexcept { return failed_; }
  const std::string& first() const noexcept { return first_; }

 private:
  static void collect(CPLErr severity, CPLErrorNum /*number*/, const char* message) {
    auto* self = static_cast<GdalErrors*>(CPLGetErrorHandlerUserData());
    if (severity < CE_Failure || self->failed_) return;
    self->failed_ = true;
    self->first_ = withoutFunction(message);
  }
  /// libtiff begins with the function that fails, "_tiffWriteProc:", which tells a user nothing.
  static std::string withoutFunction(std::string_view message) {
    const std::size_t end = message.find(':');
    const bool is_function = end != std::string_view::npos && message.find(' ') > end &&
                             (message.starts_with("TIFF") || message.starts_with("_tiff"));
    if (is_function) message.remove_prefix(end + 1);
    while (message.starts_with(' ')) message.remove_prefix(1);
    return std::string(message);
  }

  bool failed_ = false;
  std::string first_;
};

/// GeoTIFF, PNG and ESRI ASCII grid; once. [any thread]
void registerRasterDrivers();

}  // namespace relievo
