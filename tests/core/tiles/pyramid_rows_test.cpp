// SPDX-License-Identifier: BSD-3-Clause
#include "core/tiles/pyramid_rows.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace relievo {
namespace {

DepthMap someMap(GridSize size) {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> uniform(0, 5);
  DepthMap map;
  map.frame = {.size = size, .spacing_mm = 0.2, .first_x_mm = 0.1, .first_y_mm = 0.1};
  for (std::size_t i = 0; i < size.count(); ++i) {
    const float draw = uniform(random);
    map.heights_mm.push_back(draw < 1 ? 0.0F : draw);
    map.origins.push_back(draw < 0.5F ? CellStatus::outside
                          : draw < 1  ? CellStatus::base_plane
                          : draw < 2  ? CellStatus::interpolated
                                      : CellStatus::measured);
  }
  return map;
}

void expectSameAsWholeMap(GridSize size, double factor) {
  SCOPED_TRACE(std::to_string(size.cols) + " x " + std::to_string(size.rows) + ", M " +
               std::to_string(factor));
  const DepthMap map = someMap(size);
  const PyramidOptions options{.factor = factor, .coarsest_samples = 30};
  const Pyramid whole = buildPyramid(map, options);
  std::vector<int> rows(whole.levels.size());
  std::size_t other = 0;
  PyramidRows stream(map.frame, options, [&](const LevelRow& row) {
    const auto l = static_cast<std::size_t>(row.level.value);
    const PyramidLevel& level = whole.levels[l];
    ASSERT_EQ(row.row, rows[l]++);
    for (int col = 0; col < level.frame.size.cols; ++col) {
      const std::size_t i = level.frame.size.index({.col = col, .row = row.row});
      other += row.heights_mm[col] != level.heights_mm[i];
      const float of_origin =
          map.origins[i % map.origins.size()] == CellStatus::measured ? 1.0F : 0.0F;
      other += row.measured[col] != (l == 0 ? of_origin : level.measured[i]);
      const auto nearest = [&](int node, int count) {
        const double scale = level.frame.spacing_mm / map.frame.spacing_mm;
        return std::min(static_cast<int>(std::lround(node * scale)), count - 1);
      };
      other += row.origins[col] !=
               map.origin({.col = nearest(col, size.cols), .row = nearest(row.row, size.rows)});
    }
  });
  for (int row = 0; row < size.rows; ++row) {
    const std::size_t start = size.index({.col = 0, .row = row});
    stream.add(&map.heights_mm[start], &map.origins[start]);
  }
  EXPECT_EQ(other, 0U);
  const std::vector<GridFrame> frames = PyramidRows::frames(map.frame, options);
  ASSERT_EQ(frames.size(), whole.levels.size());
  for (std::size_t l = 0; l < frames.size(); ++l) {
    EXPECT_EQ(rows[l], whole.levels[l].frame.size.rows);
    EXPECT_EQ(frames[l], whole.levels[l].frame);
  }
}

TEST(PyramidRows, GiveTheBytesOfTheWholeMap) {
  for (const double factor : {2.0, 3.0, 4.0, 8.0, 1.5, 1.41421356}) {
    expectSameAsWholeMap({.cols = 211, .rows = 187}, factor);
    expectSameAsWholeMap({.cols = 64, .rows = 256}, factor);
  }
}

TEST(PyramidRows, ManageMapsOfOneRowOrColumn) {
  expectSameAsWholeMap({.cols = 500, .rows = 1}, 2);
  expectSameAsWholeMap({.cols = 1, .rows = 500}, 2);
  expectSameAsWholeMap({.cols = 1, .rows = 300}, 3);
}

}  // namespace
}  // namespace relievo
