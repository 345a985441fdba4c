// SPDX-License-Identifier: BSD-3-Clause
// PCL's reader and ours on the same bytes, under libFuzzer; RELIEVO_FUZZ_READER names the format.
// Both give the same scan to the bit, or refuse it with the same words.
#include <optional>
#include <string>

#include "core/base/error.h"
#include "core/io/formats/pcl_records.h"
#include "core/io/read_scan.h"
#include "tests/core/io/same_bytes.h"
#include "tests/fuzz/invariants.h"

namespace {

using namespace relievo;

/// A scan, or the words of its refusal.
struct Outcome {
  std::optional<Scan> scan;
  std::string refusal;
};

Outcome readBy(ReaderChoice choice, std::string_view bytes, const PclLibrary* pcl) {
  ImportOptions options;
  options.max_points = 1'000'000;
  options.accept_incomplete = bytes.size() % 2 == 1;
  options.scan.reader = choice;
  const std::filesystem::path name = "input" RELIEVO_FUZZ_SUFFIX;
  const Task task;
  Outcome outcome;
  try {
    outcome.scan = RELIEVO_FUZZ_READER({name, bytes, options, task, pcl, nullptr});
  } catch (const FileError& error) {
    outcome.refusal = error.what();
  }
  return outcome;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using fuzz::require;
  using test::sameBytes;
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const Outcome ours = readBy(ReaderChoice::own, bytes, &pclLibrary());
  const Outcome other = readBy(ReaderChoice::automatic, bytes, &pclLibrary());
  require(ours.refusal == other.refusal, "both refuse with the same words, or neither");
  if (!ours.scan) {
    fuzz::checkMessage(ours.refusal);
    return 0;
  }
  const Scan &a = *ours.scan, &b = *other.scan;
  fuzz::checkScan(b);
  require(sameBytes(a.points, b.points), "both give the same points");
  require(sameBytes(a.colours, b.colours), "both give the same colours");
  require(sameBytes(a.intensities, b.intensities), "both give the same intensities");
  require(sameBytes(a.triangles, b.triangles), "both give the same faces");
  require(a.origin == b.origin && a.info.bounds == b.info.bounds, "both give the same places");
  require(a.info.points == b.info.points &&
              englishTexts(a.info.warnings) == englishTexts(b.info.warnings),
          "both say the same of the file");
  return 0;
}
