// SPDX-License-Identifier: BSD-3-Clause
#include "data/generate/relief_f.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

#include "data/generate/ply_bytes.h"
#include "tests/data/checksum.h"

namespace relievo::samples {
namespace {

constexpr double kCellMm2 = kReliefFSpacingMm * kReliefFSpacingMm;

const Cloud& reliefF() {
  static const Cloud kCloud = makeReliefF();
  return kCloud;
}

/// Number of grid positions in a rectangle that carry no point.
double emptyAreaMm2(double left, double bottom, double right, double top) {
  const auto inside = [&](const std::array<double, 3>& p) {
    return p[0] > left && p[0] < right && p[1] > bottom && p[1] < top;
  };
  const auto points = std::count_if(reliefF().points.begin(), reliefF().points.end(), inside);
  return (right - left) * (top - bottom) - static_cast<double>(points) * kCellMm2;
}

// The area of a disc counted in cells is off by at most its rim, one cell wide.
double rimMm2(const Disc& disc) {
  return 2 * 3.15 * disc.radius_mm * kReliefFSpacingMm;
}

TEST(ReliefF, HasAPointAtEveryGridPositionButThoseInHolesAndCorner) {
  std::size_t expected = 0;
  std::size_t left_out = 0;
  for (int row = 0; row < 800; ++row) {
    for (int col = 0; col < 1200; ++col) {
      const double x = 0.125 + 0.25 * col;
      const double y = 0.125 + 0.25 * row;
      const bool in_h1 = std::hypot(x - 150, y - 60) < 10;
      const bool in_h2 = std::abs(x - 60) < 3 && std::abs(y - 160) < 3;
      const bool in_h3 = std::hypot(x - 30, y - 30) < 0.5;
      const bool in_corner = x > 280 && y < 20;
      ++((in_h1 || in_h2 || in_h3 || in_corner) ? left_out : expected);
    }
  }
  EXPECT_EQ(reliefF().points.size(), expected);
  EXPECT_EQ(expected + left_out, 960'000U);
}

TEST(ReliefF, LiesOnTheClosedFormAtEveryPoint) {
  // Written out a second time, from the specification, so that a slip in the generator shows.
  for (const auto& [x, y, z] : reliefF().points) {
    double expected = std::exp(-(y - 30) * (y - 30) / 18);
    if (x > 200) expected += 5;
    const double r2 = (x - 90) * (x - 90) + (y - 100) * (y - 100);
    if (r2 < 3600) expected += std::sqrt(5625 - r2) - 45;
    if (x > 220 && x < 260 && y > 130 && y < 170) {
      expected += 0.3 + 0.3 * std::sin(2 * 3.14159265358979323846 * x / 4);
    }
    ASSERT_NEAR(z, expected, 1e-9) << "at " << x << ", " << y;
  }
}

TEST(ReliefF, HasTheStatedHeightsAtItsLandmarks) {
  EXPECT_NEAR(reliefFHeightMm(90, 100), 30, 1e-9) << "top of the cap";
  EXPECT_NEAR(reliefFHeightMm(270, 100), 5, 1e-9) << "raised half";
  EXPECT_NEAR(reliefFHeightMm(10, 30), 1, 1e-9) << "ridge";
  EXPECT_NEAR(reliefFHeightMm(210, 30), 6, 1e-9) << "ridge on the raised half";
  EXPECT_NEAR(reliefFHeightMm(221, 150), 5.6, 1e-9) << "crest of the grating";
  EXPECT_NEAR(reliefFHeightMm(223, 150), 5.0, 1e-9) << "trough of the grating";
}

TEST(ReliefF, HasHolesOfTheStatedAreas) {
  EXPECT_NEAR(emptyAreaMm2(135, 45, 165, 75), reliefFHoleAreaMm2(1), rimMm2(kReliefFHole1));
  EXPECT_NEAR(emptyAreaMm2(50, 150, 70, 170), 36, 1e-9);
  EXPECT_NEAR(emptyAreaMm2(28, 28, 32, 32), reliefFHoleAreaMm2(3), rimMm2(kReliefFHole3));
  EXPECT_NEAR(emptyAreaMm2(270, 0, 300, 30), 400, 1e-9);
  EXPECT_NEAR(reliefFHoleAreaMm2(1), 314.159, 1e-3);
  EXPECT_NEAR(reliefFHoleAreaMm2(2), 36, 0);
  EXPECT_NEAR(reliefFHoleAreaMm2(3), 0.785, 1e-3);
}

TEST(ReliefF, CallsTheCornerOutsideAndTheHolesHoles) {
  EXPECT_TRUE(isOutside(290, 10));
  EXPECT_FALSE(isHole(290, 10));
  EXPECT_TRUE(isHole(150, 60));
  EXPECT_TRUE(isHole(60, 160));
  EXPECT_TRUE(isHole(30, 30));
  EXPECT_FALSE(isOutside(150, 60));
  EXPECT_TRUE(isOutside(-1, 100));
  EXPECT_FALSE(isHole(90, 100));
}

TEST(ReliefF, ReferenceIsTheClosedFormAndEmptyOutsideOnly) {
  const Reference reference = reliefFReference();
  std::size_t i = 0;
  for (int row = 0; row < reference.rows; ++row) {
    for (int col = 0; col < reference.cols; ++col, ++i) {
      const double x = reference.x(col);
      const double y = reference.y(row);
      if (isOutside(x, y)) {
        ASSERT_TRUE(std::isnan(reference.z[i]));
      } else {
        ASSERT_FLOAT_EQ(reference.z[i], static_cast<float>(reliefFHeightMm(x, y)));
      }
    }
  }
}

TEST(ReliefF, GivesTheSameBytesOnEveryRun) {
  const std::string first = plyBytes(reliefF());
  EXPECT_EQ(first, plyBytes(makeReliefF()));
  EXPECT_EQ(checksum(first), 6873379273632178970U);
}

TEST(ReliefF, TruncatedCopyEndsInsideARecordHalfWayThrough) {
  const std::string whole = plyBytes(reliefF());
  const std::string cut = truncatedPlyBytes(reliefF());
  EXPECT_TRUE(whole.starts_with(cut));
  const std::size_t header_bytes = whole.size() - reliefF().points.size() * 12;
  const std::size_t body_bytes = cut.size() - header_bytes;
  EXPECT_NE(body_bytes % 12, 0U);
  EXPECT_EQ(body_bytes / 12, reliefF().points.size() / 2);
}

}  // namespace
}  // namespace relievo::samples
