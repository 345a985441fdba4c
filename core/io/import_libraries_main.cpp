// SPDX-License-Identifier: BSD-3-Clause
// relievo-import-libraries: rasters and the pictures on meshes through GDAL.
#include "core/io/import_worker.h"

int main(int argc, char** argv) {
  return relievo::runImportWorker(argc, argv,
                                  {.pcl = nullptr, .read_raster = relievo::readRasterRows});
}
