// SPDX-License-Identifier: BSD-3-Clause
// One reader of scans under libFuzzer; RELIEVO_FUZZ_READER names it. What the reader accepts must
// hold together; what it refuses, it must refuse with a FileError. Everything else is a finding.
#include <string>

#include "core/base/error.h"
#include "core/io/read_scan.h"
#include "tests/fuzz/invariants.h"
#ifdef RELIEVO_FUZZ_E57
#include "tests/fuzz/e57_seal.h"
#endif

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace relievo;
  std::string_view bytes(reinterpret_cast<const char*>(data), size);
#ifdef RELIEVO_FUZZ_E57
  const std::string sealed = fuzz::withChecksums(bytes);
  bytes = sealed;
#endif
  ImportOptions options;
  options.max_points = 1'000'000;
  options.accept_incomplete = size % 2 == 1;
  const std::filesystem::path name = "input" RELIEVO_FUZZ_SUFFIX;
  const Task task;
  const ReadJob job{name, bytes, options, task};
  try {
    fuzz::checkScan(RELIEVO_FUZZ_READER(job));
  } catch (const FileError& error) {
    fuzz::checkMessage(error.what());
  }
  return 0;
}
