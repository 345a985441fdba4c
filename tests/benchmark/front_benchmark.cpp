// SPDX-License-Identifier: BSD-3-Clause
// Drawing the front of a closed cloud with hidden discs skipped, beside all of them drawn, in turn
// in one run: processor milliseconds of all threads, the best of several. The same bytes: by
// core/depth/layers/disc_raster_test.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <random>
#include <vector>

#include "core/depth/layers/disc_raster.h"
#include "core/depth/layers/surface_discs.h"

namespace {

using namespace relievo;

constexpr std::size_t kPoints = 200'000;
constexpr double kRadiusMm = 50;
constexpr int kRuns = 9;

double processorMs() {
  timespec now{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

SurfaceDiscs ball() {
  std::mt19937 random(1);
  std::normal_distribution<double> normal(0, 1);
  std::vector<std::array<float, 3>> points;
  for (std::size_t i = 0; i < kPoints; ++i) {
    const std::array<double, 3> d{normal(random), normal(random), normal(random)};
    const double scale = kRadiusMm / std::hypot(d[0], d[1], d[2]);
    points.push_back({static_cast<float>(kRadiusMm + scale * d[0]),
                      static_cast<float>(kRadiusMm + scale * d[1]),
                      static_cast<float>(kRadiusMm + scale * d[2])});
  }
  return surfaceDiscs(points, {});
}

}  // namespace

int main() {
  const SurfaceDiscs found = ball();
  const double pixel = 0.35 * found.spacing;
  const int side = static_cast<int>(2 * kRadiusMm / pixel) + 1;
  const DiscRaster raster{.size = {.cols = side, .rows = side}, .pixel_mm = pixel};
  std::array<double, 2> best{1e9, 1e9};
  for (int run = 0; run < kRuns; ++run) {
    for (const HiddenDiscs hidden : {HiddenDiscs::skipped, HiddenDiscs::drawn}) {
      const double before = processorMs();
      const auto pieces = drawDiscs(found.discs, raster, hidden, {});
      double& least = best[hidden == HiddenDiscs::skipped ? 0 : 1];
      least = std::min(least, processorMs() - before);
    }
  }
  std::printf("%zu discs on %d x %d pixels: hidden ones skipped %.1f ms, all drawn %.1f ms\n",
              found.discs.size(), side, side, best[0], best[1]);
}
