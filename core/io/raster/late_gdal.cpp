// SPDX-License-Identifier: BSD-3-Clause
// The functions of raster_file.h for programs that mostly do without GDAL: it and the 110 libraries
// behind it, loaded before main(), take longer than most verbs
// (docs/adr/0178-gdal-when-it-is-called.md). A program has either this file or
// gdal_raster_file.cpp.
#include <dlfcn.h>

#include <string>

#include "core/base/failure.h"
#include "core/file/own_program.h"
#include "core/io/raster/gdal_library.h"

namespace relievo {
namespace {

/// Stays until the process ends: GDAL is not made to be unloaded.
const GdalLibrary& loaded() {
  const std::filesystem::path file = ownProgram(kGdalLibrary, "Maps cannot be written:");
  void* const library = file.empty() ? nullptr : ::dlopen(file.c_str(), RTLD_LAZY | RTLD_LOCAL);
  void* const function = library == nullptr ? nullptr : ::dlsym(library, kGdalLibraryFunction);
  if (function == nullptr) {
    const char* const why = file.empty() ? nullptr : ::dlerror();
    throw failure<MessageId::library_not_loaded>(
        PathArgument{kGdalLibrary}, std::string(why == nullptr ? "it is missing" : why));
  }
  return *reinterpret_cast<decltype(&relievoGdalLibrary)>(function)();
}

const GdalLibrary& gdal() {
  static const GdalLibrary& once = loaded();
  return once;
}

}  // namespace

std::unique_ptr<RasterFile> createRasterFile(const std::filesystem::path& file,
                                             const RasterSpec& spec) {
  return gdal().create(file, spec);
}

std::optional<SystemFacts> systemFacts(int epsg) {
  return gdal().facts(epsg);
}

std::optional<StatedSystem> statedSystem(const std::string& stated) {
  return gdal().stated(stated);
}

std::string gdalVersion() {
  return gdal().version();
}

void prepareRasterFiles() {
  gdal().prepare();
}

}  // namespace relievo
