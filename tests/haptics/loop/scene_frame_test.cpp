// SPDX-License-Identifier: BSD-3-Clause
// The edge of the window: the proxy does not run off, the hand is not thrown.
#include "haptics/loop/scene_frame.h"

#include <gtest/gtest.h>

#include <vector>

#include "haptics/loop/haptic_core.h"
#include "tests/haptics/proxy/measure.h"

namespace relievo {
namespace {

class Frame : public ::testing::Test {
 protected:
  Frame() {
    options_.frame = true;
    options_.stiffness_by_detail = false;
    options_.force.stiffness_n_per_mm = 0.5;
  }
  HapticSample to(DeviceMm hip) {
    DeviceReading reading;
    reading.position = hip;
    reading.time_ns = now_ns_ += 1'000'000;
    return core_.tick(*space_, options_, reading, reading.time_ns);
  }

  // 80 mm of hand wide: the outermost samples lie at 39.8 mm.
  std::unique_ptr<HapticSpace> space_ = test::spaceOf(
      80, [](double x, double y) { return 2 * std::sin(0.2 * x) + std::cos(0.15 * y); }, 1, {},
      SurfaceKind::crease_aware);
  HapticOptions options_;
  HapticCore core_{ForceChain::bare};
  std::int64_t now_ns_ = 0;
};

TEST_F(Frame, TheProxyStaysOverTheWindowAndMovesNoFasterThanTheHand) {
  to({0, 0, 20});
  to({0, 0, -6});
  HapticSample last = to({0, 0, -6});
  for (int i = 0; i < 2000; ++i) {  // Out by 60 mm at 200 mm/s, along the edge, and back.
    const double x = 50 * (1 - std::cos(0.003 * i)), y = 70 * std::sin(0.004 * i);
    const HapticSample sample = to({x, y, -6});
    const GridPoint p = space_->gridFromDevice(sample.proxy);
    ASSERT_TRUE(p.x >= -1e-9 && p.x <= 199 + 1e-9 && p.y >= -1e-9 && p.y <= 199 + 1e-9);
    ASSERT_LE(norm(sample.proxy - last.proxy), 5 * norm(sample.hip - last.hip) + 1e-6) << i;
    ASSERT_LE(norm(sample.force - last.force), 0.5 * 5 * norm(sample.hip - last.hip) + 1e-6) << i;
    last = sample;
  }
}

TEST_F(Frame, AsksTheHandBackGently) {
  to({0, 0, 20});
  to({30, 0, -6});
  const HapticSample inside = to({39.7, 0, -6});
  const HapticSample beyond = to({60, 0, -6});
  EXPECT_EQ(beyond.force.x, -SceneFrame::kCushionMostN) << "back toward the window, gently";
  EXPECT_GT(inside.force.x, -0.5);
  options_.frame = false;
  EXPECT_GT(to({60, 0, -6}).proxy.x, 50) << "without the frame the surface goes on";
}

TEST_F(Frame, ThrowsNoHandThatTouchesDownBeyondTheEdge) {
  HapticSample last = to({55, 10, 10});
  double z = 10;
  for (int i = 0; i < 1500; ++i) {
    z -= 0.01;
    const HapticSample sample = to({55, 10, z});
    ASSERT_LE(norm(sample.force - last.force), 0.5 * 0.01 * 1.6 + 1e-9) << i;
    last = sample;
  }
  EXPECT_TRUE(last.contact);
  EXPECT_LT(last.force.x, -0.2);
}

TEST_F(Frame, AsksForTheNextWindowAfterALongPush) {
  to({0, 0, 20});
  to({30, 0, -6});
  int ticks = 0;
  while (to({50, 0, -6}).frame == 0 && ticks < 1000) ++ticks;
  EXPECT_EQ(ticks, static_cast<int>(SceneFrame::kPushTicks) - 1);
  EXPECT_EQ(to({50, 0, -6}).frame, kFrameRight);
  EXPECT_EQ(to({-50, -50, -6}).frame, kFrameLeft | kFrameLow);
  EXPECT_EQ(to({39, 0, -6}).frame, 0) << "back over the window";
  EXPECT_EQ(to({50, 0, -6}).frame, 0) << "and counts anew";
  EXPECT_EQ(to({50, 0, 30}).frame, 0) << "a hand in the air pushes nothing";
}

/// Work on a hand that goes round `corners` on straight ways, of the gross work.
double workOnWays(const HapticSpace& space, const HapticOptions& options,
                  const std::vector<DeviceMm>& corners) {
  constexpr int kRounds = 6, kTicks = 4000;
  HapticCore core(ForceChain::bare);
  HapticSample before;
  double net_mj = 0, gross_mj = 0;
  const auto sides = static_cast<int>(corners.size());
  for (int i = 0; i <= kRounds * sides * kTicks; ++i) {
    const auto from = static_cast<std::size_t>(i / kTicks % sides);
    const double part = static_cast<double>(i % kTicks) / kTicks;
    DeviceReading reading;
    reading.time_ns = i * 1'000'000LL;
    reading.position =
        corners[from] + part * (corners[(from + 1) % corners.size()] - corners[from]);
    const HapticSample s = core.tick(space, options, reading, reading.time_ns);
    if (i > sides * kTicks) {  // The first round begins with a hand that is put there.
      const DeviceN mean = 0.5 * (s.force + before.force);
      const DeviceMm way = s.hip - before.hip;
      const double mj = mean.x * way.x + mean.y * way.y + mean.z * way.z;
      net_mj += mj;
      gross_mj += std::abs(mj);
    }
    before = s;
  }
  EXPECT_GT(gross_mj, 1);
  return net_mj / gross_mj;
}

/// Out over the edge in the air, down there, back in below the surface, and up: with a spring that
/// pulled harder the deeper the hand is, that gave 8 mJ a round, 38 % of the gross work.
TEST_F(Frame, GoingRoundOverTheEdgeGivesNoWork) {
  const std::vector<DeviceMm> over_one_side{{30, 3, 5}, {50, 3, 5}, {50, 3, -4}, {30, 3, -4}};
  const std::vector<DeviceMm> over_a_corner{{36, 36, 5}, {46, 45, 6}, {48, 44, -5}, {35, 37, -4}};
  const std::vector<DeviceMm> along_the_edge{
      {38, -20, 4}, {41, -20, -3}, {40.5, 20, -4}, {38, 20, 3}};
  for (const auto& corners : {over_one_side, over_a_corner, along_the_edge}) {
    EXPECT_LE(workOnWays(*space_, options_, corners), 0.0002);
    EXPECT_GE(workOnWays(*space_, options_, corners), -0.002) << "nor is any lost";
  }
}

TEST_F(Frame, TheWorkspacesEdgeIsCushionedInAndOutAndWithoutAWindow) {
  options_.workspace.half_extent = {40, 40, 15};
  to({0, 0, 14});
  EXPECT_EQ(to({0, 0, 14.9}).force, DeviceN{});
  EXPECT_NEAR(to({0, 0, 17}).force.z, -2 * SceneFrame::kCushionNPerMm, 1e-9);
  EXPECT_EQ(to({0, 0, 40}).force.z, -SceneFrame::kCushionMostN);
  options_.frame = false;
  EXPECT_EQ(to({0, 0, 40}).force, DeviceN{}) << "not for a stroke";
  options_.cushion = true;
  EXPECT_NEAR(to({44, 0, 14}).force.x, -4 * SceneFrame::kCushionNPerMm, 1e-9);
  const std::vector<DeviceMm> out{{30, 0, 5}, {50, 0, 25}, {45, 0, 4}};
  EXPECT_LE(std::abs(workOnWays(*space_, options_, out)), 0.0002);
}

}  // namespace
}  // namespace relievo
