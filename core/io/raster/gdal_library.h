// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Between a program that loads GDAL when it calls it first (late_gdal.cpp) and the library that
// brings it (gdal_library.cpp).
#include "core/io/raster/raster_file.h"

namespace relievo {

/// What raster_file.h declares, made by GDAL.
struct GdalLibrary {
  decltype(&createRasterFile) create;
  decltype(&systemFacts) facts;
  decltype(&statedSystem) stated;
  decltype(&gdalVersion) version;
  decltype(&prepareRasterFiles) prepare;
};

/// The library, a file of this name, and its one function.
inline constexpr const char* kGdalLibrary = "relievo-gdal.so";
inline constexpr const char* kGdalLibraryFunction = "relievoGdalLibrary";
extern "C" const GdalLibrary* relievoGdalLibrary();

}  // namespace relievo
