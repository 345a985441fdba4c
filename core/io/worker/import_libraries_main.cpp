// SPDX-License-Identifier: BSD-3-Clause
// relievo-import-libraries: rasters and the pictures on meshes through GDAL.
#include "core/io/formats/texture_file.h"
#include "core/io/worker/import_worker.h"

int main(int argc, char** argv) {
  return relievo::runImportWorker(argc, argv,
                                  {.read = {.pcl = nullptr, .load_texture = relievo::readTexture},
                                   .read_raster = relievo::readRasterRows,
                                   .read_pixels = relievo::readPixelsHere});
}
