// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gmock/gmock.h>

#include "core/io/import.h"

/// main() of a test that imports: importScan starts this same program as its worker.
int main(int argc, char** argv) {  // NOLINT(misc-definitions-in-headers): one per program.
  if (const auto status = relievo::runImportWorkerIfAsked(argc, argv)) return *status;
  ::testing::InitGoogleMock(&argc, argv);
  return RUN_ALL_TESTS();
}
