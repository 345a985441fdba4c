// SPDX-License-Identifier: BSD-3-Clause
// What the parent believes of relievo-prepare, under libFuzzer: a library that was led astray may
// write anything.
#include <sys/mman.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <vector>

#include "core/prepare/transport.h"
#include "tests/fuzz/invariants.h"

namespace {

using namespace relievo;

/// Two scans of a few points, and steps of every kind of answer.
const PrepareJob& job() {
  static const std::vector<Point3f> kPoints{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 1}, {2, 0, 1}};
  static const PrepareJob kJob = [] {
    PrepareJob made{.steps = {Duplicates{}, Align{}, Normals{}}, .scans = {}};
    for (int i = 0; i < 2; ++i) {
      PrepareScan scan;
      scan.name = "made.ply";
      scan.points = kPoints;
      made.scans.push_back(scan);
    }
    return made;
  }();
  return kJob;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const int kMemory = ::memfd_create("relievo-fuzz", MFD_CLOEXEC);
  if (::ftruncate(kMemory, 0) != 0 ||
      ::pwrite(kMemory, data, size, 0) != static_cast<ssize_t>(size)) {
    std::abort();
  }
  const auto received = receivePrepareAnswer(kMemory, job(), {});
  const auto* const answer = std::get_if<PrepareAnswer>(&received);
  if (answer == nullptr) return 0;
  fuzz::require(answer->steps.size() == job().steps.size(), "a result for every step");
  fuzz::require(answer->poses.size() == job().scans.size(), "a pose for every scan");
  for (const Pose& pose : answer->poses) fuzz::require(isRigid(pose), "poses are rigid");
  std::uint64_t before = job().points();
  for (const StepResult& step : answer->steps) {
    fuzz::require(step.kept.size() == job().points(), "a bit for every point");
    fuzz::require(step.before == before, "each step begins where the one before it ended");
    fuzz::require(step.after == step.kept.count() && step.after <= before, "points are counted");
    before = step.after;
  }
  fuzz::require(answer->normals.empty() || answer->normals.size() == before,
                "a normal for every point that is left");
  for (const Point3f& n : answer->normals) {
    fuzz::require(std::isfinite(n[0]) && std::isfinite(n[1]) && std::isfinite(n[2]),
                  "normals are finite");
  }
  return 0;
}
