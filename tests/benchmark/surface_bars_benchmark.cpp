// SPDX-License-Identifier: BSD-3-Clause
// From a scan to a depth map and pyramid: the times and accuracies that docs/dev/surface-figures.md
// lists, on relief N. `times_memcpy` compares with a plain copy of the scan's bytes in the same
// run; `times_cloudcompare` is how many times longer CloudCompare's RASTERIZE (no fill, no pyramid;
// its own start included) takes on the same file in the same run, if it is installed. `best_s` is
// the best of the iterations: what other work on the machine adds is not the program's; where it
// takes much, `cpu_s`, the processor time of all threads, says more. Memory is that of a process
// which makes one map: `peak_MB` counts the scan's points, all that is needed in between and the
// surface with its pyramid, at the worst moment.
#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <map>
#include <memory>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include "core/depth/rules/rasterize.h"
#include "core/region/window.h"
#include "core/session/load.h"
#include "tests/core/relief_n_accuracy.h"

namespace {

namespace fs = std::filesystem;
using relievo::Scan;
using relievo::Surface;
using relievo::SurfaceOptions;

double secondsOf(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double secondsToCopy(std::size_t bytes) {
  std::vector<char> from(bytes, 1);
  std::vector<char> to(bytes);
  double best = 1e9;
  for (int i = 0; i < 5; ++i) {
    best = std::min(best, secondsOf([&] {
                      std::memcpy(to.data(), from.data(), bytes);
                      benchmark::DoNotOptimize(to.data());
                      benchmark::ClobberMemory();
                    }));
  }
  return best;
}

/// Of all threads, user and system.
double processorSeconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

/// Runs every iteration, keeps the best time and puts it beside a copy of `bytes`.
double measure(benchmark::State& state, std::size_t bytes, const std::function<void()>& work) {
  double best = 1e9;
  double least = 1e9;
  for (auto _ : state) {
    const double before = processorSeconds();
    best = std::min(best, secondsOf(work));
    least = std::min(least, processorSeconds() - before);
  }
  state.counters["best_s"] = best;
  state.counters["cpu_s"] = least;
  state.counters["times_memcpy"] = best / secondsToCopy(bytes);
  return best;
}

const Scan& reliefN(std::size_t points, double outlier_share) {
  static std::map<std::pair<std::size_t, double>, std::unique_ptr<Scan>> scans;
  auto& scan = scans[{points, outlier_share}];
  if (!scan) {
    scan = std::make_unique<Scan>(
        relievo::test::reliefNScan({.points = points, .outlier_share = outlier_share}));
  }
  return *scan;
}

void mapOf(benchmark::State& state, std::size_t points, double outlier_share, int cells,
           std::optional<relievo::PointRule> rule) {
  const Scan& scan = reliefN(points, outlier_share);
  SurfaceOptions options = relievo::test::topView(cells);
  options.rule = rule;
  Surface surface;
  measure(state, points * sizeof(scan.points[0]), [&] {
    surface = Surface();  // Nobody needs two at once.
    surface = relievo::makeSurface(scan, options, relievo::rasterize);
  });
  const auto found = relievo::test::accuracyOnReliefN(surface);
  state.counters["rms_mm"] = found.rms_mm;
  state.counters["holes_kept"] = found.holes_kept;
  state.counters["gaps_closed"] = found.gaps_closed;
  state.SetLabel(surface.rule);
}

void million(benchmark::State& state) {
  mapOf(state, 1'000'000, 0, 800, std::nullopt);
}
BENCHMARK(million)->Unit(benchmark::kMillisecond)->Iterations(5);

void millionBySplat(benchmark::State& state) {
  mapOf(state, 1'000'000, 0, 800, relievo::PointRule::splat);
}
BENCHMARK(millionBySplat)->Unit(benchmark::kMillisecond)->Iterations(5);

void tenMillionWithOutliers(benchmark::State& state) {
  mapOf(state, 10'000'000, 0.0005, 800, std::nullopt);
}
BENCHMARK(tenMillionWithOutliers)->Unit(benchmark::kMillisecond)->Iterations(5);

void fiftyMillionTo4096(benchmark::State& state) {
  mapOf(state, 50'000'000, 0, 4096, std::nullopt);
}
BENCHMARK(fiftyMillionTo4096)->Unit(benchmark::kMillisecond)->Iterations(2);

/// The highest resident memory since `forgetPeak`, bytes; 0 if the system does not say.
double peakBytes() {
  std::ifstream status("/proc/self/status");
  std::string line;
  while (std::getline(status, line)) {
    if (line.starts_with("VmHWM:")) return 1024 * std::atof(line.c_str() + 6);
  }
  return 0;
}
void forgetPeak() {
  std::ofstream("/proc/self/clear_refs") << 5;
}

/// A process of its own: makes one map and prints its seconds and memory in bytes: the points, the
/// peak, what is left with the surface.
int makeOneMap(std::size_t points, int cells) {
  const Scan& scan = reliefN(points, 0);
  const SurfaceOptions options = relievo::test::topView(cells);
  forgetPeak();
  Surface surface;
  const double seconds =
      secondsOf([&] { surface = relievo::makeSurface(scan, options, relievo::rasterize); });
  const double peak = peakBytes();
  forgetPeak();
  std::cout << seconds << ' ' << points * sizeof(scan.points[0]) << ' ' << peak << ' '
            << peakBytes() << '\n';
  return 0;
}

constexpr const char* kOneMap = "--one-map";

void memoryOfFiftyMillionTo4096(benchmark::State& state) {
  const std::string command =
      std::filesystem::read_symlink("/proc/self/exe").string() + " " + kOneMap + " 50000000 4096";
  double seconds = 0;
  double points = 0;
  double peak = 0;
  double left = 0;
  for (auto _ : state) {
    FILE* const child = popen(command.c_str(), "r");
    if (child == nullptr ||
        std::fscanf(child, "%lf %lf %lf %lf", &seconds, &points, &peak, &left) != 4) {
      std::abort();
    }
    pclose(child);
  }
  state.counters["map_s"] = seconds;
  state.counters["points_MB"] = points / 1e6;
  state.counters["peak_MB"] = peak / 1e6;
  state.counters["left_MB"] = left / 1e6;
}
BENCHMARK(memoryOfFiftyMillionTo4096)->Unit(benchmark::kSecond)->Iterations(1);

/// From asking to stop, at moments spread over the work, to its end: `worst_ms`; the bar is 250.
void cancelOfTenMillion(benchmark::State& state) {
  constexpr int kMoments = 24;
  const Scan& scan = reliefN(10'000'000, 0.0005);
  SurfaceOptions options = relievo::test::topView(static_cast<int>(state.range(0)));
  const double whole_s =
      secondsOf([&] { relievo::makeSurface(scan, options, relievo::rasterize); });
  double worst = 0;
  for (auto _ : state) {
    for (int k = 0; k < kMoments; ++k) {
      std::stop_source stop;
      std::chrono::steady_clock::time_point asked;
      std::jthread other([&] {
        std::this_thread::sleep_for(std::chrono::duration<double>(whole_s * (k + 0.5) / kMoments));
        asked = std::chrono::steady_clock::now();
        stop.request_stop();
      });
      bool stopped = false;
      try {
        relievo::makeSurface(scan, options, relievo::rasterize,
                             {.stop = stop.get_token(), .progress = {}});
      } catch (const relievo::Cancelled&) {
        stopped = true;
      }
      const auto end = std::chrono::steady_clock::now();
      other.join();
      if (stopped) worst = std::max(worst, std::chrono::duration<double>(end - asked).count());
    }
  }
  state.counters["worst_ms"] = 1e3 * worst;
  state.counters["whole_s"] = whole_s;
}
BENCHMARK(cancelOfTenMillion)->ArgName("cells")->Arg(800)->Arg(2000)->Iterations(1);

/// 158 x 316 nodes: 99 855 triangles over the relief.
void hundredThousandTriangles(benchmark::State& state) {
  static const Scan kMesh = relievo::test::latticeMesh(
      317, 159, 0.3, [](double x, double y) { return relievo::samples::reliefNHeightMm(x, y); });
  const SurfaceOptions options = relievo::test::topView(800);
  measure(state, kMesh.points.size() * 12 + kMesh.triangles.size() * 12, [&] {
    const Surface surface = relievo::makeSurface(kMesh, options, relievo::rasterize);
    benchmark::DoNotOptimize(surface.map.heights_mm.data());
  });
  state.counters["triangles"] = static_cast<double>(kMesh.triangles.size());
}
BENCHMARK(hundredThousandTriangles)->Unit(benchmark::kMillisecond)->Iterations(5);

/// Processor time of all children that have ended.
double childSeconds() {
  rusage used{};
  getrusage(RUSAGE_CHILDREN, &used);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(used.ru_utime) + seconds(used.ru_stime);
}

class PlyFile {
 public:
  explicit PlyFile(const Scan& scan)
      : path_(fs::temp_directory_path() / "relievo_benchmark_relief_n.ply") {
    std::ofstream out(path_, std::ios::binary);
    out << "ply\nformat binary_little_endian 1.0\nelement vertex " << scan.points.size()
        << "\nproperty float x\nproperty float y\nproperty float z\nend_header\n";
    out.write(reinterpret_cast<const char*>(scan.points.data()),
              static_cast<std::streamsize>(scan.points.size() * sizeof(scan.points[0])));
  }
  PlyFile(const PlyFile&) = delete;
  PlyFile& operator=(const PlyFile&) = delete;
  ~PlyFile() { fs::remove(path_); }
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

bool isInstalled(const char* program) {
  return std::system((std::string("command -v ") + program + " >/dev/null").c_str()) == 0;
}

/// CloudCompare's grid of maxima on the same file and cell, on a screen of its own.
double cloudCompareSeconds(const fs::path& file, double cell_mm) {
  const std::string command = "xvfb-run -a CloudCompare -SILENT -AUTO_SAVE OFF -O '" +
                              file.string() + "' -RASTERIZE -GRID_STEP " + std::to_string(cell_mm) +
                              " -VERT_DIR 2 -PROJ MAX >/dev/null 2>&1";
  double best = 1e9;
  for (int i = 0; i < 3; ++i) {
    best = std::min(best, secondsOf([&] {
                      if (std::system(command.c_str()) != 0) std::abort();
                    }));
  }
  return best;
}

void fromPly(benchmark::State& state, std::optional<relievo::PointRule> rule) {
  const Scan& scan = reliefN(1'000'000, 0);
  const PlyFile file(scan);
  SurfaceOptions options = relievo::test::topView(800);
  options.rule = rule;
  Surface surface;
  const double best = measure(state, scan.points.size() * 12, [&] {
    surface = relievo::loadSurface(file.path(), options, relievo::rasterize);
  });
  state.counters["read_s"] = surface.seconds.read;
  state.counters["rms_mm"] = relievo::test::accuracyOnReliefN(surface).rms_mm;
  state.SetLabel(surface.rule);
  if (isInstalled("CloudCompare") && isInstalled("xvfb-run")) {
    state.counters["times_cloudcompare"] = cloudCompareSeconds(file.path(), 100.0 / 799) / best;
  }
}

void millionFromPly(benchmark::State& state) {
  fromPly(state, std::nullopt);
}
BENCHMARK(millionFromPly)->Unit(benchmark::kMillisecond)->Iterations(7);

void millionFromPlyBySplat(benchmark::State& state) {
  fromPly(state, relievo::PointRule::splat);
}
BENCHMARK(millionFromPlyBySplat)->Unit(benchmark::kMillisecond)->Iterations(7);

/// The program from its start to its end, as people start it. @param state  points, cells across
void program(benchmark::State& state) {
  const auto points = static_cast<std::size_t>(state.range(0));
  const std::int64_t cells = state.range(1);
  const PlyFile file(reliefN(points, 0));
  const std::string map = file.path().string() + ".tif";
  const std::string command = RELIEVO_BINARY_DIR "/bin/relievo depthmap '" + file.path().string() +
                              "' --unit mm --view top --cells " + std::to_string(cells) + " -o '" +
                              map + "' >/dev/null 2>&1";
  double best = 1e9;
  double best_cpu = 1e9;
  for (auto _ : state) {
    const double cpu = childSeconds();
    best = std::min(best, secondsOf([&] {
                      if (std::system(command.c_str()) != 0) std::abort();
                    }));
    best_cpu = std::min(best_cpu, childSeconds() - cpu);
  }
  fs::remove(map);
  fs::remove(file.path().string() + ".origin.tif");
  state.counters["best_s"] = best;
  state.counters["cpu_s"] = best_cpu;
  if (isInstalled("CloudCompare") && isInstalled("xvfb-run")) {
    const double other = cloudCompareSeconds(file.path(), 100.0 / static_cast<double>(cells - 1));
    state.counters["cloudcompare_s"] = other;
    state.counters["times_cloudcompare"] = other / best;
  }
}
BENCHMARK(program)
    ->ArgNames({"points", "cells"})
    ->Args({1'000'000, 633})
    ->Args({10'000'000, 2001})
    ->Unit(benchmark::kMillisecond)
    ->Iterations(7);

/// @param state  range(0): 1 if the samples lie on the level's nodes; range(1): their distance in
///               hundredths of the nodes'
void windowOf200(benchmark::State& state) {
  const Surface surface =
      relievo::makeSurface(reliefN(1'000'000, 0), relievo::test::topView(800), relievo::rasterize);
  const relievo::GridFrame& frame = surface.map.frame;
  const double step = frame.spacing_mm;
  const double side = 2 * static_cast<double>(state.range(1)) * step;
  const bool aligned = state.range(0) == 1;
  int shift = 0;
  double best = 1e9;
  for (auto _ : state) {
    shift = (shift + 7) % 500;
    const double off = aligned ? 0 : 0.37 * step;
    const double seconds = secondsOf([&] {
      const relievo::RegionWindow window = relievo::sampleWindow(
          surface.map, surface.pyramid,
          {.x_mm = shift * step + off, .y_mm = 200 * step + off, .side_mm = side, .level = {0}});
      benchmark::DoNotOptimize(window.heights_mm.data());
    });
    best = std::min(best, seconds);
  }
  state.counters["best_us"] = 1e6 * best;
  state.counters["times_memcpy"] = best / secondsToCopy(relievo::kWindowCount * sizeof(float));
}
BENCHMARK(windowOf200)
    ->ArgNames({"aligned", "hundredths"})
    ->ArgsProduct({{1, 0}, {100}})
    ->ArgsProduct({{0}, {83, 130}})
    ->Unit(benchmark::kMicrosecond);

}  // namespace

int main(int argc, char** argv) {
  if (argc == 4 && std::string(argv[1]) == kOneMap) {
    return makeOneMap(std::strtoull(argv[2], nullptr, 10), std::atoi(argv[3]));
  }
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
