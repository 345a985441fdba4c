// SPDX-License-Identifier: BSD-3-Clause
// One proxy update on rough terrain, always in contact, beside the paper's 5.6 us.
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdio>
#include <map>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "haptics/loop/haptic_core.h"
#include "haptics/proxy/proxy.h"
#include "haptics/proxy/surface.h"
#include "tests/haptics/proxy/measure.h"

namespace relievo {
namespace {

constexpr double kPaperMicroseconds = 5.6;  // Sec. 6: average proxy update, Core 2 Quad 2.66 GHz.

std::unique_ptr<HapticSpace> terrain(SurfaceKind kind) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> noise(-0.05, 0.05);
  return test::spaceOf(
      80,
      [&](double x, double y) {
        return 1.5 * std::sin(0.5 * x) + 1.2 * std::cos(0.43 * y + 0.2 * x) +
               0.3 * std::sin(1.7 * x + y) + noise(random);
      },
      1, {}, kind);
}

/// Waves of 20 samples, the scene on which the peers were measured.
std::unique_ptr<HapticSpace> waves(SurfaceKind kind) {
  return test::spaceOf(test::waves(1, 10), 100, kind);
}

/// A closed path of the hand 1 mm below the surface along its normal, about 85 mm/s at 1 kHz.
std::vector<GridPoint> strokeBelow(const HapticSpace& space) {
  std::vector<GridPoint> path;
  constexpr int kTicks = 20'000;
  for (int i = 0; i < kTicks; ++i) {
    const double turn = 2 * std::acos(-1.0) * i / kTicks;
    const double x = 99.5 + 80 * std::sin(8 * turn), y = 99.5 + 80 * std::sin(6 * turn + 0.4);
    const Jet jet = surfaceJet(space, x, y);
    path.push_back(GridPoint{x, y, jet.f} - (1 / space.cell_mm) * normalOf(jet));
  }
  return path;
}

using Scene = std::unique_ptr<HapticSpace> (*)(SurfaceKind);

void follow(benchmark::State& state, ProxyKind kind, Scene scene, SurfaceKind surface) {
  const auto space = scene(surface);
  const std::vector<GridPoint> path = strokeBelow(*space);
  ProxyOptions options;
  options.kind = kind;
  ProxyState proxy = proxyPlace(*space, path[0]);
  std::size_t i = 0;
  for ([[maybe_unused]] auto step : state) {
    i = i + 1 == path.size() ? 0 : i + 1;
    proxy = proxyTick(*space, proxy, path[i], options);
    benchmark::DoNotOptimize(proxy);
  }
  state.counters["paper_us"] = kPaperMicroseconds;
}

void convergedGated(benchmark::State& state) {
  follow(state, ProxyKind::converged, waves, SurfaceKind::crease_aware);
}
void convergedSpline(benchmark::State& state) {
  follow(state, ProxyKind::converged, waves, SurfaceKind::spline);
}
void convergedBilinear(benchmark::State& state) {
  follow(state, ProxyKind::converged, waves, SurfaceKind::bilinear);
}
void creaseAwareOnTerrain(benchmark::State& state) {
  follow(state, ProxyKind::converged, terrain, SurfaceKind::crease_aware);
}
void bilinearOnTerrain(benchmark::State& state) {
  follow(state, ProxyKind::converged, terrain, SurfaceKind::bilinear);
}
void equationTimes100(benchmark::State& state) {
  follow(state, ProxyKind::equation, waves, SurfaceKind::bilinear);
}
void successiveUpTo100(benchmark::State& state) {
  follow(state, ProxyKind::successive, waves, SurfaceKind::bilinear);
}

void wholeTick(benchmark::State& state) {
  const auto space = terrain(SurfaceKind::crease_aware);
  const std::vector<GridPoint> path = strokeBelow(*space);
  HapticCore core;
  HapticOptions options;
  options.force.forces_on = true;
  std::size_t i = 0;
  std::int64_t now_ns = 0;
  for ([[maybe_unused]] auto step : state) {
    i = i + 1 == path.size() ? 0 : i + 1;
    now_ns += 1'000'000;
    DeviceReading reading;
    reading.position = space->deviceFromGrid(path[i]);
    reading.time_ns = now_ns;
    benchmark::DoNotOptimize(core.tick(*space, options, reading, now_ns));
  }
  state.counters["paper_us"] = kPaperMicroseconds;
}

BENCHMARK(convergedGated)->Unit(benchmark::kMicrosecond);
BENCHMARK(convergedSpline)->Unit(benchmark::kMicrosecond);
BENCHMARK(convergedBilinear)->Unit(benchmark::kMicrosecond);
BENCHMARK(creaseAwareOnTerrain)->Unit(benchmark::kMicrosecond);
BENCHMARK(bilinearOnTerrain)->Unit(benchmark::kMicrosecond);
BENCHMARK(equationTimes100)->Unit(benchmark::kMicrosecond);
BENCHMARK(successiveUpTo100)->Unit(benchmark::kMicrosecond);
BENCHMARK(wholeTick)->Unit(benchmark::kMicrosecond);

/// Prints as usual and remembers the times, for the ratios at the end.
class RatioReporter : public benchmark::ConsoleReporter {
 public:
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) us_[run.benchmark_name()] = run.GetAdjustedCPUTime();
    ConsoleReporter::ReportRuns(runs);
  }
  void printRatios() const {
    const auto converged_us = us_.find("convergedBilinear"),
               equation_us = us_.find("equationTimes100");
    if (converged_us == us_.end() || equation_us == us_.end()) return;
    std::printf(
        "\nOne converged update takes %.3f us: the paper's 100 updates of eq. (2) %.1f times "
        "that,\n"
        "the time that the paper reports, %.1f us, %.1f times.\n",
        converged_us->second, equation_us->second / converged_us->second, kPaperMicroseconds,
        kPaperMicroseconds / converged_us->second);
  }

 private:
  std::map<std::string, double> us_;
};

}  // namespace
}  // namespace relievo

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  relievo::RatioReporter reporter;
  benchmark::RunSpecifiedBenchmarks(&reporter);
  reporter.printRatios();
  return 0;
}
