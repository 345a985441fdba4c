// SPDX-License-Identifier: BSD-3-Clause
// relievo-import-pcl: binary PCD through PCL; without GDAL, which takes longer to load than most
// files to read.
#include "core/io/formats/pcl_records.h"
#include "core/io/worker/import_worker.h"

int main(int argc, char** argv) {
  return relievo::runImportWorker(
      argc, argv,
      {.read = {.pcl = &relievo::pclLibrary(), .load_texture = nullptr}, .read_raster = nullptr});
}
