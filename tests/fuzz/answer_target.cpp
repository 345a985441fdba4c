// SPDX-License-Identifier: BSD-3-Clause
// What the parent believes of its import worker, under libFuzzer: a reader that was led astray may
// write anything.
#include <sys/mman.h>
#include <unistd.h>

#include <cstdlib>
#include <vector>

#include "core/base/error.h"
#include "core/io/worker/scan_transport.h"
#include "tests/fuzz/invariants.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace relievo;
  static const int kMemory = ::memfd_create("relievo-fuzz", MFD_CLOEXEC);
  if (::ftruncate(kMemory, 0) != 0 ||
      ::pwrite(kMemory, data, size, 0) != static_cast<ssize_t>(size)) {
    std::abort();
  }
  const WorkerAnswer answer = receiveAnswer(kMemory, {});
  if (const auto* scan = std::get_if<Scan>(&answer)) {
    fuzz::require(scan->points.size() == scan->info.finite_points, "points are counted");
    for (const auto& triangle : scan->triangles) {
      for (const std::uint32_t corner : triangle) {
        fuzz::require(corner < scan->points.size(), "corners are points");
      }
    }
  }
  if (const auto* raster = std::get_if<RasterRows>(&answer)) {
    const GridSize size = raster->head().size;
    std::vector<float> heights(static_cast<std::size_t>(size.cols));
    std::vector<CellStatus> origins(heights.size());
    try {
      for (int row = 0; row < size.rows; ++row)
        raster->read(row, 1, heights.data(), origins.data());
    } catch (const FileError& error) {
      fuzz::checkMessage(error.what());
    }
  }
  return 0;
}
