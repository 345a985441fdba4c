// SPDX-License-Identifier: BSD-3-Clause
// What reading in a process of its own costs: each import program on a file of one point, beside
// /bin/true started the same way in the same run (`times_true`); a million points of binary PLY
// through the import and read right here, beside a plain copy of the file's bytes
// (`times_memcpy`).
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include "core/io/import.h"
#include "core/io/raster/raster.h"
#include "core/io/read_scan.h"
#include "core/io/worker/spawn.h"

namespace {

namespace fs = std::filesystem;

double secondsOf(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double bestOf(benchmark::State& state, const std::function<void()>& work) {
  double best = 1e9;
  for (auto _ : state) best = std::min(best, secondsOf(work));
  state.counters["best_ms"] = 1e3 * best;
  return best;
}

double secondsOfTrue() {
  double best = 1e9;
  for (int i = 0; i < 50; ++i) {
    best = std::min(
        best, secondsOf([] {
          relievo::ChildProcess child;
          child.start(
              {.program = "/bin/true", .arguments = {"true"}, .more_environment = {}, .fds = {}});
          child.reap(true);
        }));
  }
  return best;
}

double secondsToCopy(std::size_t bytes) {
  std::vector<char> from(bytes, 1);
  std::vector<char> to(bytes);
  double best = 1e9;
  for (int i = 0; i < 20; ++i) {
    best = std::min(best, secondsOf([&] {
                      std::memcpy(to.data(), from.data(), bytes);
                      benchmark::DoNotOptimize(to.data());
                      benchmark::ClobberMemory();
                    }));
  }
  return best;
}

/// Removed at the end.
class File {
 public:
  File(const std::string& name, const std::string& bytes)
      : path_(fs::temp_directory_path() / ("relievo_import_benchmark_" + name)) {
    std::ofstream(path_, std::ios::binary) << bytes;
  }
  ~File() { fs::remove(path_); }
  File(const File&) = delete;
  File& operator=(const File&) = delete;
  const fs::path& path() const noexcept { return path_; }

 private:
  fs::path path_;
};

std::string ply(std::size_t points) {
  std::string bytes = "ply\nformat binary_little_endian 1.0\nelement vertex " +
                      std::to_string(points) +
                      "\nproperty float x\nproperty float y\nproperty float z\nend_header\n";
  for (std::size_t i = 0; i < 3 * points; ++i) {
    const auto number = static_cast<float>(i % 1999) / 16;
    bytes.append(reinterpret_cast<const char*>(&number), sizeof(number));
  }
  return bytes;
}

void onePoint(benchmark::State& state) {
  const File file("one.ply", ply(1));
  const double best =
      bestOf(state, [&] { benchmark::DoNotOptimize(relievo::importScan(file.path())); });
  state.counters["times_true"] = best / secondsOfTrue();
}
BENCHMARK(onePoint)->Unit(benchmark::kMillisecond)->Iterations(50);

void oneRaster(benchmark::State& state) {
  const File file("one.asc", "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 2\n3 4\n");
  const double best =
      bestOf(state, [&] { benchmark::DoNotOptimize(relievo::importRaster(file.path())); });
  state.counters["times_true"] = best / secondsOfTrue();
}
BENCHMARK(oneRaster)->Unit(benchmark::kMillisecond)->Iterations(20);

void millionImported(benchmark::State& state) {
  const std::string bytes = ply(1'000'000);
  const File file("million.ply", bytes);
  const double best =
      bestOf(state, [&] { benchmark::DoNotOptimize(relievo::importScan(file.path())); });
  state.counters["times_memcpy"] = best / secondsToCopy(bytes.size());
}
BENCHMARK(millionImported)->Unit(benchmark::kMillisecond)->Iterations(20);

void millionReadHere(benchmark::State& state) {
  const std::string bytes = ply(1'000'000);
  const File file("million_here.ply", bytes);
  const double best = bestOf(
      state, [&] { benchmark::DoNotOptimize(relievo::readScanHere(file.path(), {}, {}, {})); });
  state.counters["times_memcpy"] = best / secondsToCopy(bytes.size());
}
BENCHMARK(millionReadHere)->Unit(benchmark::kMillisecond)->Iterations(20);

}  // namespace

BENCHMARK_MAIN();
