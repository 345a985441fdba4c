// SPDX-License-Identifier: BSD-3-Clause
// What colours cost beside heights, in one run and on one thread: nanoseconds of processor time,
// the best of several. Limits: 7 ns a point and 4 ns a cell more (issue 13; adr/0095).
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <random>

#include "core/depth/colours/colours.h"
#include "core/depth/fill/fill.h"
#include "core/depth/rules/rasterize.h"
#include "core/pyramid/colour_levels.h"
#include "core/region/window.h"
#include "core/region/window_colours.h"
#include "tests/core/scan_fixtures.h"

namespace {

using namespace relievo;

constexpr int kSide = 800;
constexpr int kRuns = 7;

/// Points anywhere on 800 x 800 cells of a smooth relief, of any colour.
Scan scattered(std::size_t points) {
  Scan scan;
  std::mt19937_64 random(31);
  std::uniform_real_distribution<float> uniform(0, kSide - 1);
  for (std::size_t i = 0; i < points; ++i) {
    const float x = uniform(random);
    const float y = uniform(random);
    scan.points.push_back({x, y, 20 * std::sin(x / 70) * std::cos(y / 90)});
    const auto bits = random();
    scan.colours.push_back({static_cast<std::uint8_t>(bits), static_cast<std::uint8_t>(bits >> 8U),
                            static_cast<std::uint8_t>(bits >> 16U), 255});
  }
  test::finishScan(scan);
  return scan;
}

template <class Work>
double bestNs(const Work& work) {
  double best = 1e300;
  for (int run = 0; run < kRuns; ++run) {
    const std::clock_t start = std::clock();
    work();
    best = std::min(best, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
  }
  return 1e9 * best;
}

void row(const char* what, double ns, double of, const char* unit) {
  std::printf("%-44s %8.2f ns a %s\n", what, ns / of, unit);
}

void ofPoints(std::size_t count) {
  const Scan scan = scattered(count);
  const GridFrame frame{
      .size = {.cols = kSide, .rows = kSide}, .spacing_mm = 1, .first_x_mm = 0, .first_y_mm = 0};
  const auto request = [&](PointRule rule) {
    return DepthRequest{
        .scan = scan, .view_from_file = {}, .frame = frame, .rule = rule, .threads = 1};
  };
  const auto points = static_cast<double>(count);
  std::printf("%zu points on %d x %d cells\n", count, kSide, kSide);
  row("heights, front", bestNs([&] { rasterize(request(PointRule::front)); }), points, "point");
  row("heights, mean of the top layer", bestNs([&] { rasterize(request(PointRule::top_mean)); }),
      points, "point");
  const FilledMap filled = fillDepths(rasterize(request(PointRule::top_mean)), frame, {}, {});
  DepthRequest placed = request(PointRule::top_mean);
  placed.view_from_file.m[11] = -filled.base_z_mm;
  row("colours, mean of the layer (with filling)",
      bestNs([&] { gridColours(placed, filled.map, ColourRule::layer); }), points, "point");
  row("colours, the winner's (with filling)",
      bestNs([&] { gridColours(placed, filled.map, ColourRule::winner); }), points, "point");
}

void ofCells() {
  const Scan scan = scattered(2'000'000);
  const GridFrame frame{
      .size = {.cols = kSide, .rows = kSide}, .spacing_mm = 1, .first_x_mm = 0, .first_y_mm = 0};
  const DepthRequest request{.scan = scan,
                             .view_from_file = {},
                             .frame = frame,
                             .rule = PointRule::top_mean,
                             .threads = 1};
  const FilledMap filled = fillDepths(rasterize(request), frame, {}, {});
  DepthRequest placed = request;
  placed.view_from_file.m[11] = -filled.base_z_mm;
  const GridColours finest = gridColours(placed, filled.map, ColourRule::layer);
  const auto cells = static_cast<double>(frame.size.count());
  const Pyramid pyramid = buildPyramid(filled.map, {.threads = 1});
  row("pyramid of heights", bestNs([&] { buildPyramid(filled.map, {.threads = 1}); }), cells,
      "cell");
  row("pyramid of colours", bestNs([&] { colourLevels(GridColours(finest), pyramid, 1); }), cells,
      "cell");
  const auto levels = colourLevels(GridColours(finest), pyramid, 1);
  const Region region{.x_mm = 100.3, .y_mm = 100.3, .side_mm = 180, .level = Level{0}};
  const RegionWindow window = sampleWindow(filled.map, pyramid, region);
  constexpr double kSamples = kWindowCount;
  row("window of heights", bestNs([&] { sampleWindow(filled.map, pyramid, region); }), kSamples,
      "sample");
  const GridFrame& nodes = pyramid.levels[0].frame;
  row("window of colours",
      bestNs([&] { windowColours(nodesOf(levels[0], nodes.size), nodes, window); }), kSamples,
      "sample");
}

}  // namespace

int main() {
  ofPoints(1'000'000);
  ofPoints(10'000'000);
  ofCells();
}
