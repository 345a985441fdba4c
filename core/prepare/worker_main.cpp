// SPDX-License-Identifier: BSD-3-Clause
// relievo-prepare: cleans, aligns, joins and thins scans, by FLANN and PCL.
#include "core/prepare/align/align_scans.h"
#include "core/prepare/worker.h"

int main(int argc, char** argv) {
  return relievo::runPrepareWorker(argc, argv, relievo::alignScans);
}
