// SPDX-License-Identifier: BSD-3-Clause
// Filling a map by bands beside filling it as a whole, as it was done before (docs/adr/0233), in
// turn in one run: wall milliseconds, the best of several, and whether the bytes are the same.
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <limits>
#include <random>
#include <string>
#include <utility>

#include "core/depth/fill/fill.h"
#include "tests/core/depth/fill/whole_fill.h"

namespace {

using namespace relievo;

constexpr float kNothing = std::numeric_limits<float>::quiet_NaN();

struct Input {
  std::string name;
  CapturedDepths depths;
  FillSource source = {};
  HoleChoice holes = {};
};

/// A relief of which a share of the cells is hit, with a hole, a corner that belongs to nothing,
/// and a share of cells that show the back.
FrontDepths relief(int side, double hit, double back, bool has_hole) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(0, 1);
  FrontDepths depths;
  for (int row = 0; row < side; ++row) {
    for (int col = 0; col < side; ++col) {
      const bool is_hit = unit(random) < hit;
      const double draw = unit(random);
      const bool hole = std::hypot(col - 0.3 * side, row - 0.6 * side) < 0.08 * side;
      const bool left_out = has_hole && (hole || col + row < 0.4 * side);
      const double z = 20 + 3 * std::sin(col / 19.0) * std::cos(row / 23.0);
      depths.push_back(is_hit && !left_out ? static_cast<float>(draw < back ? z - 15 : z)
                                           : kNothing);
    }
  }
  return depths;
}

/// Small holes all over it.
FrontDepths pierced(int side) {
  FrontDepths depths = relief(side, 0.97, 0, true);
  for (int hole = 0; hole < side * side / 900; ++hole) {
    const int col = hole * 7919 % (side - 6);
    const int row = hole * 104729 % (side - 6);
    for (int k = 0; k < 30; ++k) {
      depths[static_cast<std::size_t>((row + k / 6) * side + col + k % 6)] = kNothing;
    }
  }
  return depths;
}

std::vector<Input> inputs(int side) {
  std::vector<Input> all;
  const FillSource raster{.has_sampling_gaps = false};
  all.push_back({"a raster", relief(side, 1, 0, false), raster});
  all.push_back({"a raster with holes", relief(side, 1, 0, true), raster});
  all.push_back({"the same, interpolated",
                 relief(side, 1, 0, true),
                 raster,
                 {.rule = HoleRule::interpolate, .max_area_mm2 = 1e9}});
  all.push_back({"a cloud of 2.5 points a cell", relief(side, 0.92, 0.02, true)});
  all.push_back({"a cloud of 0.4 points a cell", relief(side, 0.3, 0.02, true)});
  Input between{"a cloud with heights between", relief(side, 0.6, 0, true)};
  between.depths.between = relief(side, 1, 0, true);
  between.depths.one_layer = true;
  between.source.gaps_are_known = true;
  all.push_back(std::move(between));
  all.push_back({"membranes over small holes",
                 pierced(side),
                 raster,
                 {.rule = HoleRule::membrane, .max_area_mm2 = 40}});
  return all;
}

void compare(const Input& input, int side) {
  const GridFrame frame{.size = {.cols = side, .rows = side},
                        .spacing_mm = 0.5,
                        .first_x_mm = 0.25,
                        .first_y_mm = 0.25};
  std::array<double, 2> best{1e9, 1e9};
  std::array<FilledMap, 2> made;
  const int runs = side < 500 ? 40 : side < 2000 ? 9 : 3;
  for (int run = 0; run < runs; ++run) {
    for (const std::size_t by_bands : {std::size_t{0}, std::size_t{1}}) {
      CapturedDepths depths = input.depths;
      const auto start = std::chrono::steady_clock::now();
      made[by_bands] =
          by_bands == 1 ? fillDepths(std::move(depths), frame, input.source, input.holes)
                        : test::fillWholeMap(std::move(depths), frame, input.source, input.holes);
      const std::chrono::duration<double, std::milli> taken =
          std::chrono::steady_clock::now() - start;
      best[by_bands] = std::min(best[by_bands], taken.count());
    }
  }
  const bool same = made[0].map.heights_mm == made[1].map.heights_mm &&
                    made[0].map.origins == made[1].map.origins;
  std::printf("| %d | %s | %.1f | %.1f | %.2f | %s |\n", side, input.name.c_str(), best[0], best[1],
              best[1] / best[0], same ? "yes" : "NO");
}

}  // namespace

int main() {
  std::printf("| side | input | whole, ms | bands, ms | ratio | same bytes |\n");
  std::printf("|---:|---|---:|---:|---:|---|\n");
  for (const int side : {200, 1000, 4096}) {
    for (const Input& input : inputs(side)) {
      if (side < 4096 || input.holes.rule != HoleRule::membrane) compare(input, side);
    }
  }
  return 0;
}
