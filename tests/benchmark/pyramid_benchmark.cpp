// SPDX-License-Identifier: BSD-3-Clause
// All levels of a pyramid with M = 2 down to 200 samples, against OpenCV's pyrDown on the same
// heights and threads and against a plain copy of the heights, each measured in the same run:
// `times_opencv` below 1 is faster than OpenCV, `times_memcpy` is how far the memory is from being
// the limit. `ns_per_cell` counts the cells of level 0.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <functional>
#include <opencv2/imgproc.hpp>
#include <span>
#include <vector>

#include "core/pyramid/halve.h"
#include "core/pyramid/kernel.h"
#include "core/pyramid/pyramid.h"

namespace {

using relievo::DepthMap;
using relievo::GridSize;

constexpr int kCoarsest = 200;
constexpr int kRepeats = 7;

DepthMap relief(int side) {
  DepthMap map;
  map.frame = {
      .size = {.cols = side, .rows = side}, .spacing_mm = 0.125, .first_x_mm = 0, .first_y_mm = 0};
  map.origins.assign(map.frame.size.count(), relievo::CellStatus::measured);
  for (int row = 0; row < side; ++row) {
    for (int col = 0; col < side; ++col) {
      map.heights_mm.push_back(2.5F + 2.5F * std::sin(static_cast<float>(col) / 57) *
                                          std::cos(static_cast<float>(row) / 71));
    }
  }
  return map;
}

/// The best of a few: what other work on the machine adds is not the program's.
double bestSeconds(const std::function<void()>& work) {
  double best = 1e9;
  for (int i = 0; i < kRepeats; ++i) {
    const auto start = std::chrono::steady_clock::now();
    work();
    best = std::min(
        best, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  return best;
}

void ourLevels(const DepthMap& map, int threads) {
  GridSize size = map.frame.size;
  std::vector<relievo::LargeArray<float>> levels;
  while (std::max(size.cols, size.rows) > kCoarsest) {
    const GridSize next{.cols = relievo::reducedCount(size.cols, 2),
                        .rows = relievo::reducedCount(size.rows, 2)};
    const std::span<const float> fine =
        levels.empty() ? std::span<const float>(map.heights_mm) : levels.back();
    levels.push_back(relievo::halved(fine, size, next, threads, {}));
    size = next;
  }
  benchmark::DoNotOptimize(levels.back().data());
}

void openCvLevels(const cv::Mat& finest) {
  std::vector<cv::Mat> levels{finest};
  while (std::max(levels.back().cols, levels.back().rows) > kCoarsest) {
    cv::Mat next;
    cv::pyrDown(levels.back(), next);
    levels.push_back(next);
  }
  benchmark::DoNotOptimize(levels.back().data);
}

double copySeconds(const std::vector<float>& from) {
  std::vector<float> to(from.size());
  return bestSeconds([&] {
    std::memcpy(to.data(), from.data(), from.size() * sizeof(float));
    benchmark::DoNotOptimize(to.data());
    benchmark::ClobberMemory();
  });
}

void compare(benchmark::State& state, DepthMap& map, double ours_s) {
  const int side = map.frame.size.cols;
  const cv::Mat finest(side, side, CV_32F, map.heights_mm.data());
  state.counters["best_ms"] = 1e3 * ours_s;
  state.counters["ns_per_cell"] = 1e9 * ours_s / static_cast<double>(map.heights_mm.size());
  state.counters["times_opencv"] = ours_s / bestSeconds([&] { openCvLevels(finest); });
  state.counters["times_memcpy"] = ours_s / copySeconds(map.heights_mm);
}

void heightsOnly(benchmark::State& state) {
  DepthMap map = relief(static_cast<int>(state.range(0)));
  const int threads = static_cast<int>(state.range(1));
  cv::setNumThreads(threads);
  for (auto _ : state) ourLevels(map, threads);
  compare(state, map, bestSeconds([&] { ourLevels(map, threads); }));
}
BENCHMARK(heightsOnly)
    ->ArgNames({"side", "threads"})
    ->ArgsProduct({{800, 4096}, {1, 2}})
    ->Unit(benchmark::kMillisecond);

/// With level 0 copied and the share of measured cells carried along: more than OpenCV does.
void wholePyramid(benchmark::State& state) {
  DepthMap map = relief(static_cast<int>(state.range(0)));
  const int threads = static_cast<int>(state.range(1));
  cv::setNumThreads(threads);
  const auto build = [&] {
    const relievo::Pyramid pyramid = relievo::buildPyramid(map, {.threads = threads});
    benchmark::DoNotOptimize(pyramid.levels.back().heights_mm.data());
  };
  for (auto _ : state) build();
  compare(state, map, bestSeconds(build));
}
BENCHMARK(wholePyramid)
    ->ArgNames({"side", "threads"})
    ->ArgsProduct({{800, 4096}, {1, 2}})
    ->Unit(benchmark::kMillisecond);

/// One halving on one thread, with the rows of the next call asked for meanwhile, or not: what the
/// prefetches in halve.cpp buy. Without: the rows that are asked for are there already.
void halving(benchmark::State& state) {
  const DepthMap map = relief(static_cast<int>(state.range(0)));
  const GridSize size = map.frame.size;
  const bool asks_ahead = state.range(1) != 0;
  std::vector<float> out((static_cast<std::size_t>(size.cols) + 1) / 2);
  const auto row_at = [&](int row) {
    const int there = relievo::mirrored(row, size.rows);
    return map.heights_mm.data() + size.index({.col = 0, .row = there});
  };
  relievo::RowHalver halve(size.cols);
  for (auto _ : state) {
    for (int j = 0; j < (size.rows + 1) / 2; ++j) {
      relievo::FiveRows rows{};
      for (int n = 0; n < 5; ++n) rows[static_cast<std::size_t>(n)] = row_at(2 * j - 2 + n);
      const int ahead = asks_ahead ? 2 * j + 3 : 2 * j;
      halve(rows, {row_at(ahead), row_at(ahead + 1)}, out.data());
      benchmark::DoNotOptimize(out.data());
    }
  }
}
BENCHMARK(halving)
    ->ArgNames({"side", "asks_ahead"})
    ->ArgsProduct({{800, 4096, 8192}, {0, 1}})
    ->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
