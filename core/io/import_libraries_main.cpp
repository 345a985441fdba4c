// SPDX-License-Identifier: BSD-3-Clause
// relievo-import-libraries: rasters through GDAL, compressed PCD through PCL, and all the rest.
#include "core/io/import_worker.h"

int main(int argc, char** argv) {
  return relievo::runImportWorker(
      argc, argv, {.unpack_lzf = relievo::unpackLzf, .read_raster = relievo::readRasterRows});
}
