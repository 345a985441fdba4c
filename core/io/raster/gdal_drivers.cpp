// SPDX-License-Identifier: BSD-3-Clause
#include <mutex>

#include "core/io/raster/gdal_session.h"

namespace relievo {

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

}  // namespace relievo
