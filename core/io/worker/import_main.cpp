// SPDX-License-Identifier: BSD-3-Clause
// relievo-import: our own readers, and PCL's parser of PLY. Loads none of the large libraries, so
// that it starts at once.
#include "core/io/formats/pcl_records.h"
#include "core/io/worker/import_worker.h"

int main(int argc, char** argv) {
  return relievo::runImportWorker(
      argc, argv,
      {.looks_first = true, .read = {.pcl = &relievo::pclPlyLibrary(), .load_texture = nullptr}});
}
