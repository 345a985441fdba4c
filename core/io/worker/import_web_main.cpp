// SPDX-License-Identifier: BSD-3-Clause
// relievo-import-web: fetches and unpacks published maps through GDAL's file systems.
#include "core/io/web/web_worker.h"

int main(int argc, char** argv) {
  return relievo::runWebWorker(argc, argv);
}
