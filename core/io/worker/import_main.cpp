// SPDX-License-Identifier: BSD-3-Clause
// relievo-import: our own readers. Loads none of the large libraries, so that it starts at once.
#include "core/io/worker/import_worker.h"

int main(int argc, char** argv) {
  return relievo::runImportWorker(argc, argv, {});
}
