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

}  // namespace
}  // namespace relievo

int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  const QCoreApplication app(argc, argv);
  return RUN_ALL_TESTS();
}
