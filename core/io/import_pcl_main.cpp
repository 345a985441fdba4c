// SPDX-License-Identifier: BSD-3-Clause
// relievo-import-pcl: binary PCD and PLY points through PCL; without GDAL, which takes longer to
// load than most files to read.
#include "core/io/import_worker.h"
#include "core/io/pcl_records.h"

int main(int argc, char** argv) {
  return relievo::runImportWorker(
      argc, argv,
      {.read = {.pcl = &relievo::pclLibrary(), .load_texture = nullptr}, .read_raster = nullptr});
}
