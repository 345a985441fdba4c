// SPDX-License-Identifier: BSD-3-Clause
// The edge of the window: the proxy does not run off, the hand is not thrown.
#include "haptics/loop/scene_frame.h"

#include <gtest/gtest.h>

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
    options_.force.safety = false;
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
      SurfaceKind::gated);
  HapticOptions options_;
  HapticCore core_;
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
  EXPECT_LT(beyond.force.x, inside.force.x - 0.2) << "back toward the window";
  EXPECT_GT(beyond.force.x, inside.force.x - 1.5) << "gently";
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

}  // namespace
}  // namespace relievo
