// SPDX-License-Identifier: BSD-3-Clause
// The reader of rasters (ours around GDAL's) under libFuzzer.
#include "core/base/error.h"
#include "core/io/raster.h"
#include "tests/fuzz/input_file.h"
#include "tests/fuzz/invariants.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace relievo;
  if (size > (1U << 16U)) return 0;
  static const fuzz::InputFile kInput(".tif");
  kInput.write({reinterpret_cast<const char*>(data), size});
  try {
    const RasterMap raster = readRaster(kInput.path());
    fuzz::require(raster.values.size() == raster.size.count(), "a value for every cell");
    fuzz::require(raster.valid.size() == raster.size.count(), "a word on every cell");
    fuzz::require(raster.info.finite_points > 0 && raster.info.bounds.has_value(), "some height");
    fuzz::require(std::isfinite(raster.pixel) && raster.pixel > 0, "a pixel's size");
    for (std::size_t i = 0; i < raster.values.size(); ++i) {
      fuzz::require(!raster.valid[i] || std::isfinite(raster.values[i]), "valid cells are finite");
    }
  } catch (const FileError& error) {
    fuzz::checkMessage(error.what());
  }
  return 0;
}
