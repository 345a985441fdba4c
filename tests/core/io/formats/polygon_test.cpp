// SPDX-License-Identifier: BSD-3-Clause
#include "core/io/formats/polygon.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "core/io/import.h"
#include "tests/core/io/temporary_folder.h"

namespace relievo {
namespace {

using Corner = std::array<float, 3>;
using Corners = std::vector<Corner>;
using Vector = std::array<double, 3>;

Vector crossOf(const Corner& a, const Corner& b, const Corner& c) {
  Vector u{}, v{};
  for (std::size_t i = 0; i < 3; ++i) {
    u[i] = static_cast<double>(b[i]) - static_cast<double>(a[i]);
    v[i] = static_cast<double>(c[i]) - static_cast<double>(a[i]);
  }
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}
double lengthOf(const Vector& v) {
  return std::hypot(v[0], v[1], v[2]);
}

/// Twice the vector area of the outline.
Vector areaOf(const Corners& corners) {
  Vector sum{};
  for (std::size_t i = 2; i < corners.size(); ++i) {
    const Vector part = crossOf(corners[0], corners[i - 1], corners[i]);
    for (std::size_t k = 0; k < 3; ++k) sum[k] += part[k];
  }
  return sum;
}

/// Triangles of one orientation whose areas add up to the outline's cover it exactly: one outside,
/// or two on top of each other, would make the sum of sizes larger than the size of the sum.
void expectCovered(const Corners& corners) {
  std::vector<PolygonTriangle> triangles;
  EXPECT_TRUE(cutPolygon(corners, triangles));
  EXPECT_EQ(triangles.size(), corners.size() - 2);
  const Vector whole = areaOf(corners);
  double sizes = 0;
  for (const auto& [a, b, c] : triangles) {
    const Vector area = crossOf(corners[a], corners[b], corners[c]);
    sizes += lengthOf(area);
    const double along = area[0] * whole[0] + area[1] * whole[1] + area[2] * whole[2];
    EXPECT_GE(along, -1e-5 * lengthOf(whole) * lengthOf(whole));
  }
  EXPECT_NEAR(sizes, lengthOf(whole), 1e-5 * lengthOf(whole));
}

TEST(Polygon, AConvexOneIsTheFanOfItsFirstCorner) {
  for (const std::size_t count : {3U, 4U, 5U, 12U}) {
    Corners corners;
    for (std::size_t i = 0; i < count; ++i) {
      const double angle =
          2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(count);
      corners.push_back(
          {static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle)), 5});
    }
    std::vector<PolygonTriangle> triangles;
    cutPolygon(corners, triangles);
    ASSERT_EQ(triangles.size(), count - 2);
    for (std::uint32_t i = 2; i < count; ++i) {
      EXPECT_EQ(triangles[i - 2], (PolygonTriangle{0, i - 1, i}));
    }
  }
}

TEST(Polygon, LettersAndCombsAreCovered) {
  expectCovered({{0, 0, 0}, {3, 0, 0}, {3, 1, 0}, {1, 1, 0}, {1, 3, 0}, {0, 3, 0}});  // L
  expectCovered({{0, 0, 0}, {4, 2, 0}, {0, 4, 0}, {1, 2, 0}});                        // Arrow
  Corners comb{{0, 0, 0}};
  for (int tooth = 0; tooth < 20; ++tooth) {
    const auto x = static_cast<float>(2 * tooth);
    comb.push_back({x + 1, 10, 0});
    comb.push_back({x + 2, 1, 0});
  }
  comb.push_back({40, 0, 0});
  expectCovered(comb);
}

TEST(Polygon, AHoleJoinedByACutIsLeftOpen) {
  // A square with a square hole, the outline going in and out along one line.
  expectCovered({{0, 0, 0},
                 {4, 0, 0},
                 {4, 4, 0},
                 {0, 4, 0},
                 {0, 0, 0},
                 {1, 1, 0},
                 {1, 3, 0},
                 {3, 3, 0},
                 {3, 1, 0},
                 {1, 1, 0}});
}

TEST(Polygon, RandomStarsInAnyPlaneAreCovered) {
  std::mt19937_64 random(77);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int trial = 0; trial < 500; ++trial) {
    SCOPED_TRACE(trial);
    const std::size_t count = 4 + random() % 40;
    Vector u{uniform(random) - 0.5, uniform(random) - 0.5, uniform(random) - 0.5};
    Vector v{uniform(random) - 0.5, uniform(random) - 0.5, uniform(random) - 0.5};
    Corners corners;
    for (std::size_t i = 0; i < count; ++i) {
      const double angle = 2 * std::numbers::pi * (static_cast<double>(i) + 0.4 * uniform(random)) /
                           static_cast<double>(count);
      const double radius = 0.2 + uniform(random);
      Corner corner{};
      for (std::size_t k = 0; k < 3; ++k) {
        corner[k] = static_cast<float>(radius * (std::cos(angle) * u[k] + std::sin(angle) * v[k]));
      }
      corners.push_back(corner);
    }
    expectCovered(corners);
  }
}

TEST(Polygon, OneThatCrossesItselfIsCutSomehow) {
  std::vector<PolygonTriangle> triangles;
  EXPECT_TRUE(
      cutPolygon(Corners{{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 2, 0}, {5, 1, 0}}, triangles));
  EXPECT_EQ(triangles.size(), 3U);
  EXPECT_TRUE(cutPolygon(Corners(9, {1, 1, 1}), triangles));
}

TEST(Polygon, AnArrowInAFileHasNoTriangleOutsideOfIt) {
  const test::TemporaryFolder folder;
  const Scan scan =
      importScan(folder.write("a.obj", "v 0 0 0\nv 4 2 0\nv 0 4 0\nv 1 2 0\nf 1 2 3 4\n"));
  ASSERT_EQ(scan.triangles.size(), 2U);
  double sizes = 0;
  for (const auto& t : scan.triangles) {
    sizes += lengthOf(crossOf(scan.points[t[0]], scan.points[t[1]], scan.points[t[2]]));
  }
  EXPECT_DOUBLE_EQ(sizes, 12);  // The fan of corner 1 would cover 20.
}

}  // namespace
}  // namespace relievo
