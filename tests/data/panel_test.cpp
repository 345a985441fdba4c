// SPDX-License-Identifier: BSD-3-Clause
#include "data/generate/panel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "data/generate/ply_bytes.h"
#include "tests/data/checksum.h"
#include "tests/data/empty_squares.h"

namespace relievo::samples {
namespace {

const Cloud& panel() {
  static const Cloud kCloud = makePanel();
  return kCloud;
}

TEST(Panel, HasTheStatedSize) {
  EXPECT_EQ(panel().points.size(), 600'000U);
  double highest = 0;
  for (const auto& p : panel().points) highest = std::max(highest, p[2]);
  EXPECT_GT(highest, 35);
  EXPECT_LT(highest, 42);
}

TEST(Panel, EveryPointLiesOnASurfaceWithinTheScannersNoise) {
  for (const auto& [x, y, z] : panel().points) {
    // Blended joints make the distance a lower bound; it is never more than the true one.
    ASSERT_LT(std::abs(panelDistanceMm(x, y, z)), 6.5 * kPanelNoiseMm + 0.002)
        << "at " << x << ", " << y << ", " << z;
  }
}

TEST(Panel, HasSurfaceThatCannotBeSeenFromTheFront) {
  constexpr std::size_t kEvery = 20;
  std::size_t hidden = 0;
  std::size_t tried = 0;
  for (std::size_t i = 0; i < panel().points.size(); i += kEvery, ++tried) {
    const auto& [x, y, z] = panel().points[i];
    if (z < panelHeightMm(x, y) - 2) ++hidden;
  }
  EXPECT_GT(hidden, tried / 100) << "undercuts";
  EXPECT_LT(hidden, tried / 4);
}

TEST(Panel, FrontMostHeightHasNothingBeforeItAndSurfaceAtIt) {
  for (int i = 0; i < 400; ++i) {
    const double x = 5 + 0.7 * i;
    const double y = 10 + std::fmod(31.7 * i, 180);
    const double z = panelHeightMm(x, y);
    EXPECT_LT(std::abs(panelDistanceMm(x, y, z)), 0.001);
    for (double above = z + 0.01; above < 42; above += 0.25) {
      ASSERT_GT(panelDistanceMm(x, y, above), 0) << "at " << x << ", " << y << ", " << above;
    }
  }
}

TEST(Panel, FiguresOverlap) {
  // The trunk of the elephant hides part of the horse behind it: walking back from the front, there
  // is surface, air and surface again before the ground.
  int overlaps = 0;
  for (double x = 145; x < 180; x += 1) {
    for (double y = 55; y < 110; y += 1) {
      int entered = 0;
      bool inside = false;
      for (double z = 42; z > 2; z -= 0.25) {
        const bool now = panelDistanceMm(x, y, z) < 0;
        if (now && !inside) ++entered;
        inside = now;
      }
      if (entered >= 2) ++overlaps;
    }
  }
  EXPECT_GT(overlaps, 50);
}

TEST(Panel, HasPlacesThatNoScannerSaw) {
  const SquareCounts counts(panel(), 0, 0, 300, 200, 1.5);
  EXPECT_LT(counts.empty([](double, double) { return true; }), 40U)
      << "from the front everything is covered";
  const auto ground_points = [](double left, double bottom) {
    return std::count_if(panel().points.begin(), panel().points.end(), [&](const auto& p) {
      return p[0] > left && p[0] < left + 25 && p[1] > bottom && p[1] < bottom + 20 && p[2] < 4;
    });
  };
  const auto under_the_belly = ground_points(70, 95);
  const auto in_the_open = ground_points(115, 150);
  EXPECT_GT(in_the_open, 1000);
  EXPECT_LT(under_the_belly, in_the_open / 20);
}

TEST(Panel, IsScannedMoreDenselyInTheMiddle) {
  const SquareCounts counts(panel(), 0, 0, 300, 200, 20);
  EXPECT_GT(static_cast<double>(counts.at(150, 90)),
            1.5 * static_cast<double>(counts.at(290, 190)));
}

TEST(Panel, ReferenceIsTheFrontMostHeightAtItsSamples) {
  const Reference reference = panelReference();
  const std::size_t i = 500U * 1200U + 321U;
  EXPECT_FLOAT_EQ(reference.z[i],
                  static_cast<float>(panelHeightMm(reference.x(321), reference.y(500))));
  EXPECT_TRUE(
      std::none_of(reference.z.begin(), reference.z.end(), [](float z) { return std::isnan(z); }));
}

TEST(Panel, GivesTheSameBytesOnEveryRun) {
  const std::string first = plyBytes(panel());
  EXPECT_EQ(first, plyBytes(makePanel()));
  EXPECT_EQ(checksum(first), 7084942144377852825U);
}

}  // namespace
}  // namespace relievo::samples
