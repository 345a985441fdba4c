// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/haptics/loop_session.h"

#include <gtest/gtest.h>

#include <cmath>
#include <QCoreApplication>
#include <utility>

#include "tests/plugins/plugin_fixture.h"

namespace relievo {
namespace {

using test::eventually;

TEST(LoopSession, PushesThatComeFasterThanTheHandFollowsAddUp) {
  const test::PrivateHome home;
  LoopSession session("mouse");
  session.show(test::windowOf(
                   80, [](double, double) { return 5.0; }, 7),
               SurfaceKind::bilinear);
  ASSERT_TRUE(eventually([&] { return session.update().window_id == 7; }));
  const DeviceMm from = session.update().hip;
  const auto comesTo = [&](double x_mm) {
    return eventually([&] { return std::abs(session.update().hip.x - x_mm) < 0.01; });
  };
  for (int i = 0; i < 5; ++i) session.pushHand({1, 0, 0});
  EXPECT_TRUE(comesTo(from.x + 5)) << session.update().hip.x - from.x;
  // A push that is far ahead of the hand waits for it.
  for (int i = 0; i < 1000; ++i) session.pushHand({-1, 0, 0});
  double before = from.x;
  EXPECT_TRUE(eventually([&] {
    const double x = session.update().hip.x;
    const bool rests = x < from.x && std::abs(x - std::exchange(before, x)) < 1e-6;
    return rests;
  }));
  EXPECT_GT(before, from.x - 500);
}

RegionWindow flatWindow(std::uint64_t id) {
  return test::windowOf(
      80, [](double, double) { return 5.0; }, id);
}

TEST(LoopSession, ASurfaceIsPreparedWhileTheWindowGoesOn) {
  const test::PrivateHome home;
  LoopSession session("mouse");
  session.show(flatWindow(7), SurfaceKind::gated);
  EXPECT_TRUE(session.hasWindow());
  const std::uint64_t ticks = session.stats().ticks;
  ASSERT_TRUE(eventually([&] { return session.stats().ticks > ticks + 20; }));
  session.loop().latest().update();
  EXPECT_EQ(session.loop().latest().front().scene_id, 0U)
      << "whoever showed it did not wait for it";
  EXPECT_TRUE(eventually([&] { return session.update().window_id == 7; }));
}

TEST(LoopSession, ANewerWindowReplacesTheOneThatWaits) {
  const test::PrivateHome home;
  LoopSession session("mouse");
  for (const std::uint64_t id : {1, 2, 3}) session.show(flatWindow(id), SurfaceKind::gated);
  ASSERT_TRUE(eventually([&] { return session.update().window_id == 3; }));
  EXPECT_EQ(session.update().scene_id, 2U) << "the second window was never prepared";
}

TEST(LoopSession, ASurfaceThatCannotBePreparedIsTold) {
  const test::PrivateHome home;
  LoopSession session("mouse");
  SceneMaps maps;
  maps.firmness.assign(3, 1.0F);  // 200 by 200 are needed.
  session.show(flatWindow(7), SurfaceKind::gated, std::move(maps));
  std::string problem;
  ASSERT_TRUE(eventually([&] {
    session.update();
    problem = session.takeProblem();
    return !problem.empty();
  }));
  EXPECT_EQ(session.takeProblem(), "") << "once";
  session.show(flatWindow(8), SurfaceKind::gated);
  EXPECT_TRUE(eventually([&] { return session.update().window_id == 8; }));
}

}  // namespace
}  // namespace relievo

int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  const QCoreApplication app(argc, argv);
  return RUN_ALL_TESTS();
}
