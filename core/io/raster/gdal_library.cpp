// SPDX-License-Identifier: BSD-3-Clause
#include "core/io/raster/gdal_library.h"

namespace relievo {

const GdalLibrary* relievoGdalLibrary() {
  static constexpr GdalLibrary kFunctions{&createRasterFile, &systemFacts, &statedSystem,
                                          &gdalVersion, &prepareRasterFiles};
  return &kFunctions;
}

}  // namespace relievo
