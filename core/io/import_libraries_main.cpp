// SPDX-License-Identifier: BSD-3-Clause
// relievo-import-libraries: rasters and the pictures on meshes through GDAL.
#include "core/io/import_worker.h"
#include "core/io/texture_file.h"

int main(int argc, char** argv) {
  return relievo::runImportWorker(argc, argv,
                                  {.read = {.pcl = nullptr, .load_texture = relievo::readTexture},
                                   .read_raster = relievo::readRasterRows});
}
