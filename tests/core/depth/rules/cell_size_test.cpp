// SPDX-License-Identifier: BSD-3-Clause
#include "core/depth/rules/cell_size.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/core/scan_fixtures.h"

namespace relievo {
namespace {

const Rotation kTop = *standardRotation("top");

TEST(ProposeCells, FollowsARegularGridExactly) {
  const Scan scan = test::latticeScan(301, 201, 0.25, [](double, double) { return 0.0; });
  EXPECT_EQ(proposeCells(scan, kTop).cells, 301);
}

TEST(ProposeCells, FollowsAGridWithGapsAndAnOrigin) {
  Scan scan = test::latticeScan(301, 201, 0.5, [](double x, double) { return x; });
  std::erase_if(scan.points, [](const auto& p) { return p[0] > 40 && p[0] < 60 && p[1] > 30; });
  scan.origin = {500'000, 5'400'000, 200};
  test::finishScan(scan);
  EXPECT_EQ(proposeCells(scan, kTop).cells, 301);
}

TEST(ProposeCells, GivesAScatteredCloudTwoToFourPointsACell) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<float> uniform(0, 100);
  for (const int count : {2000, 50'000, 400'000}) {
    Scan scan;
    for (int i = 0; i < count; ++i) {
      scan.points.push_back({uniform(random), uniform(random), uniform(random)});
    }
    test::finishScan(scan);
    const int cells = proposeCells(scan, kTop).cells;
    const double points_per_cell = static_cast<double>(count) / (cells * cells);
    EXPECT_GT(points_per_cell, 2) << count;
    EXPECT_LT(points_per_cell, 4) << count;
  }
}

TEST(ProposeCells, GivesAMeshThePapersGrid) {
  const Scan mesh = test::latticeMesh(5, 5, 1, [](double, double) { return 0.0; });
  EXPECT_EQ(proposeCells(mesh, kTop).cells, 800);
}

}  // namespace
}  // namespace relievo
