// SPDX-License-Identifier: BSD-3-Clause
// Which windows are worth touching, against reliefs whose answer is known: ridges just below and
// just above what a hand feels (Louw, Kappers, Koenderink 2000), walls, and what nobody measured.
#include "core/session/feelable.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "core/base/error.h"

namespace relievo {
namespace {

constexpr int kSide = 400;
constexpr double kSpacing = 0.1;
constexpr double kRidgeSigma = 0.4;  // Two samples of level 1.

DepthMap mapOf(const std::function<double(double, double)>& z) {
  DepthMap map;
  map.frame = {{kSide, kSide}, kSpacing, 0.5 * kSpacing, 0.5 * kSpacing};
  for (int row = 0; row < kSide; ++row) {
    for (int col = 0; col < kSide; ++col) {
      map.heights_mm.push_back(
          static_cast<float>(5 + z((col + 0.5) * kSpacing, (row + 0.5) * kSpacing)));
    }
  }
  map.origins.assign(map.frame.size.count(), CellStatus::measured);
  return map;
}

/// Ridges along y, 4 mm apart, in the lower left quarter of the map alone. They run out slowly: an
/// end stands out more than a ridge does.
std::function<double(double, double)> ridges(double height_mm) {
  return [height_mm](double x, double y) {
    if (x > 18 || y > 20) return 0.0;
    const double d = std::remainder(x, 4.0) / kRidgeSigma;
    const double end = y < 10 ? 1 : 0.5 + 0.5 * std::cos((y - 10) * 0.1 * std::numbers::pi);
    return height_mm * end * std::exp(-0.5 * d * d);
  };
}

std::vector<FeelableWindow> windowsOf(const DepthMap& map, const FeelOptions& options = {}) {
  return feelableWindows(map, buildPyramid(map), options);
}

bool overlapsTheRidges(const Region& region) {
  return region.x_mm < 20 && region.y_mm < 20;
}

TEST(JustFelt, IsTheLawOfLouwAndProportionalBelowItsMillimetre) {
  EXPECT_DOUBLE_EQ(justFeltMm(240), 8);
  EXPECT_NEAR(justFeltMm(100), 2.6, 0.05);  // As numbers read off the published figure.
  EXPECT_NEAR(justFeltMm(10), 0.13, 0.005);
  EXPECT_NEAR(justFeltMm(1), 0.0064, 0.0005);
  EXPECT_NEAR(justFeltMm(0.5), 0.5 * justFeltMm(1), 1e-12);
}

TEST(FeelableWindows, RelievesAreFoundWhereTheyAre) {
  const std::vector<FeelableWindow> windows = windowsOf(mapOf(ridges(0.3)));
  ASSERT_FALSE(windows.empty());
  const FeelableWindow& best = windows.front();
  EXPECT_EQ(best.region.level, Level{0});
  EXPECT_NEAR(best.region.x_mm, 0, 1e-9);
  EXPECT_NEAR(best.region.y_mm, 0, 1e-9);
  EXPECT_NEAR(best.region.side_mm, 20, 1e-9);
  EXPECT_GT(best.width_mm, 4 * kRidgeSigma / std::sqrt(2.0)) << "bands are a factor 2 apart";
  EXPECT_LT(best.width_mm, 4 * kRidgeSigma * std::sqrt(2.0));
  EXPECT_EQ(best.measured_share, 1);
  // Four ridges as wide as that in 20 mm, a quarter of their length running out.
  EXPECT_NEAR(best.felt_share, 4 * (4 * kRidgeSigma) / 20 * 0.8, 0.1);
  for (std::size_t i = 1; i < windows.size(); ++i) {
    EXPECT_LE(windows[i].score, windows[i - 1].score);
    EXPECT_TRUE(overlapsTheRidges(windows[i].region)) << "there is nothing elsewhere";
  }
}

// At level 0 the window of 20 mm lies under the hand four times as large, a ridge of 1.6 mm as one
// of 6.4 mm. The bands tell its height within 6 %.
TEST(FeelableWindows, AreThereFromTheHeightOnThatIsJustFelt) {
  const FeelOptions options;
  const double least = options.grip_factor * justFeltMm(4 * kRidgeSigma * 4) / 4;
  EXPECT_TRUE(windowsOf(mapOf(ridges(0.9 * least)), options).empty());
  const auto some = windowsOf(mapOf(ridges(1.15 * least)), options);
  ASSERT_FALSE(some.empty());
  EXPECT_EQ(some.front().region.level, Level{0});
  FeelOptions raised = options;
  raised.gain = 2;
  EXPECT_FALSE(windowsOf(mapOf(ridges(0.9 * least)), raised).empty());
  raised = {.gain = 1, .grip_factor = 3};
  EXPECT_FALSE(windowsOf(mapOf(ridges(0.9 * least)), raised).empty());
}

TEST(FeelableWindows, OfWhatWasNotMeasuredThereAreNone) {
  DepthMap map = mapOf(ridges(0.3));
  for (int row = 0; row < kSide; ++row) {
    for (int col = 0; col < kSide; ++col) {
      if (row < 210 && col < 210)
        map.origins[map.frame.size.index({col, row})] = CellStatus::interpolated;
    }
  }
  EXPECT_TRUE(windowsOf(map).empty());
}

TEST(FeelableWindows, AWallIsToldAndDoesNotCount) {
  const DepthMap map = mapOf([](double x, double) { return std::clamp(4 * (x - 19), 0.0, 8.0); });
  const std::vector<FeelableWindow> windows = windowsOf(map);
  ASSERT_FALSE(windows.empty());
  double steepest = 0;
  for (const FeelableWindow& window : windows) steepest = std::max(steepest, window.steep_share);
  EXPECT_NEAR(steepest, 0.1, 0.03) << "2 of the 20 mm of a window";
}

TEST(FeelableWindows, OfOneLevelHardlyOverlapAndAreAtMostAsManyAsAsked) {
  const DepthMap map =
      mapOf([](double x, double y) { return 0.2 * std::sin(x * 4) * std::cos(y * 4); });
  const std::vector<FeelableWindow> all = windowsOf(map);
  ASSERT_GT(all.size(), 2U);
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Region &a = all[i].region, &b = all[j].region;
      if (a.level != b.level) continue;
      const double wide = std::max(0.0, a.side_mm - std::abs(a.x_mm - b.x_mm));
      const double high = std::max(0.0, a.side_mm - std::abs(a.y_mm - b.y_mm));
      EXPECT_LE(wide * high, 0.2501 * a.side_mm * a.side_mm);
    }
  }
  EXPECT_EQ(windowsOf(map, {.most = 2}).size(), 2U);
}

TEST(FeelableWindows, WrongNumbersAreRefusedAndAStopIsObeyed) {
  const DepthMap map = mapOf(ridges(0.3));
  for (const FeelOptions& wrong : {FeelOptions{.gain = 0}, FeelOptions{.grip_factor = -1},
                                   FeelOptions{.most = 0}, FeelOptions{.gain = std::nan("")}}) {
    EXPECT_THROW(windowsOf(map, wrong), ArgumentError);
  }
  std::stop_source stop;
  stop.request_stop();
  EXPECT_THROW(
      feelableWindows(map, buildPyramid(map), {}, Task{.stop = stop.get_token(), .progress = {}}),
      Cancelled);
}

}  // namespace
}  // namespace relievo
