// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/haptics/loop_session.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <QCoreApplication>
#include <utility>

#include "core/recording/log_table.h"
#include "core/region/hand.h"
#include "haptics/record/recorded_loop.h"
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
  session.show(flatWindow(7), SurfaceKind::crease_aware);
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
  for (const std::uint64_t id : {1, 2, 3}) session.show(flatWindow(id), SurfaceKind::crease_aware);
  ASSERT_TRUE(eventually([&] { return session.update().window_id == 3; }));
  EXPECT_EQ(session.update().scene_id, 2U) << "the second window was never prepared";
}

TEST(LoopSession, ASurfaceThatNobodyFeelsWaitsForTheNextOne) {
  const test::PrivateHome home;
  LoopSession session("mouse");
  session.setUnfeltEvery(std::chrono::hours(1));
  const auto isShown = [&](std::uint64_t id) {
    return eventually([&] { return session.update().window_id == id; });
  };
  session.show(flatWindow(1), SurfaceKind::crease_aware);
  ASSERT_TRUE(isShown(1)) << "the first one waits for nothing";
  session.show(flatWindow(2), SurfaceKind::crease_aware);
  for (int frame = 0; frame < 50; ++frame) session.update();
  EXPECT_TRUE(session.isPreparing());
  EXPECT_EQ(session.update().window_id, 1U);
  session.show(flatWindow(3), SurfaceKind::crease_aware);
  HapticOptions options;
  options.force.forces_on = true;
  session.setOptions(options);
  ASSERT_TRUE(isShown(3)) << "with forces on each one is felt";
  EXPECT_EQ(session.update().scene_id, 2U) << "the second one was never prepared";
  session.show(flatWindow(4), SurfaceKind::crease_aware);
  EXPECT_TRUE(isShown(4));
}

/// A wall across the middle, 30 mm high and 4 mm thick.
RegionWindow walledWindow(std::uint64_t id) {
  return test::windowOf(
      80, [](double x, double) { return std::abs(x - 40) < 2 ? 30.0 : 0.0; }, id);
}

bool rests(LoopSession& session) {
  HapticSample before = session.update();
  return eventually([&] {
    const HapticSample& now = session.update();
    if (now.tick < before.tick + 5) return false;
    return norm(now.hip - std::exchange(before, now).hip) < 1e-3;
  });
}

TEST(LoopSession, AHandThatIsNotPressedIsCarriedOverAWall) {
  const test::PrivateHome home;
  LoopSession session("mouse");
  const RegionWindow window = walledWindow(7);
  session.show(window, SurfaceKind::crease_aware);
  ASSERT_TRUE(eventually([&] { return session.update().window_id == 7; }));
  for (const double x : {10.0, 70.0, 40.0, 12.0}) {
    session.moveHand(handOver(window, x, 40, false, 0));
    ASSERT_TRUE(eventually([&] { return std::abs(session.update().hip_view.x - x) < 0.01; }));
    EXPECT_FALSE(session.update().contact) << x;
    EXPECT_EQ(session.update().proxy, session.update().hip) << x;
  }
}

TEST(LoopSession, AHandTouchesWhereItIsPutDownHoweverFarItCame) {
  const test::PrivateHome home;
  LoopSession session("mouse");
  const RegionWindow window = walledWindow(7);
  session.show(window, SurfaceKind::crease_aware);
  ASSERT_TRUE(eventually([&] { return session.update().window_id == 7; }));
  session.moveHand(handOver(window, 10, 40, false, 0));
  ASSERT_TRUE(eventually([&] { return std::abs(session.update().hip_view.x - 10) < 0.01; }));
  session.moveHand(handOver(window, 70, 40, true, 2));
  ASSERT_TRUE(eventually([&] { return session.update().contact; }));
  ASSERT_TRUE(rests(session));
  EXPECT_NEAR(session.update().proxy_view.x, 70, 0.1);
  EXPECT_NEAR(norm(session.update().proxy - session.update().hip), 2, 0.01);
  // From there on it touches what is on its way: a wall holds.
  session.moveHand(handOver(window, 10, 40, true, 2));
  ASSERT_TRUE(eventually([&] { return std::abs(session.update().hip_view.x - 10) < 0.01; }));
  EXPECT_GT(session.update().proxy_view.x, 41);
}

TEST(LoopSession, WindowsThatComeUnderAHoveringHandAreNotPressed) {
  const test::PrivateHome home;
  LoopSession session("mouse");
  for (std::uint64_t id = 1; id <= 60; ++id) {
    // A hill and a hollow in turns under the same hand.
    const RegionWindow window = test::windowOf(
        80,
        [id](double x, double y) {
          const bool inner = std::hypot(x - 40, y - 40) < 20;
          return inner == (id % 2 == 0) ? 60.0 : 0.0;
        },
        id);
    session.show(window, SurfaceKind::crease_aware);
    ASSERT_TRUE(eventually([&] { return session.update().window_id == id; }));
    for (int look = 0; look < 20; ++look) {
      ASSERT_FALSE(session.update().contact) << id;
      QCoreApplication::processEvents(QEventLoop::AllEvents, 1);
    }
    ASSERT_TRUE(rests(session));
    const ViewMm hip = session.update().hip_view;
    ASSERT_GT(hip.z, windowHeightMm(window, hip.x, hip.y)) << id;
  }
}

TEST(LoopSession, ARecordingThatBeginsWhileTheHandIsLedIsReplayedToTheLastBit) {
  const test::PrivateHome home;
  const RegionWindow window = flatWindow(7);
  const std::string file = home.file("led.csv").toStdString();
  {
    LoopSession session("virtual:relaxed");
    session.show(window, SurfaceKind::crease_aware);
    ASSERT_TRUE(eventually([&] { return session.update().window_id == 7; }));
    HapticOptions options;
    options.force.forces_on = true;
    options.bound_by_rate = false;  // A busy computer makes the loop slow.
    session.setOptions(options);
    ASSERT_TRUE(eventually([&] { return session.update().engaged == EngagePhase::on; }));
    std::vector<DeviceMm> circle;
    for (int i = 0; i < 40; ++i) {
      const double a = 2 * std::acos(-1.0) * i / 40;
      circle.push_back({16 * std::cos(a), 16 * std::sin(a), 0});
    }
    const auto lead = [&] {
      options.guide.path = session.lead(guidePath(circle, true, kMostRounds));
      session.setOptions(options);
    };
    const auto until = [&](const std::function<bool(const HapticSample&)>& holds) {
      return eventually([&] {
        const HapticSample sample = session.update();
        session.giveWay(sample);
        return holds(sample);
      });
    };
    lead();
    ASSERT_TRUE(until([](const HapticSample& s) { return s.guide == GuidePhase::leading; }));
    session.startRecording(file, "relievo recording, schema 1");
    ASSERT_TRUE(until([&](const HapticSample&) { return session.recorder().samples() > 500; }));
    lead();  // Anew, from where the hand is.
    ASSERT_TRUE(until([&](const HapticSample& s) {
      return s.guide_path == options.guide.path && s.guide == GuidePhase::leading;
    }));
    session.stopRecording("");
    ASSERT_TRUE(eventually([&] { return session.recorder().ended().has_value(); }));
  }
  const LogTable log = readLog(file);
  const auto loop = recordedLoop(log.footer);
  ASSERT_TRUE(loop);
  EXPECT_EQ(loop->guides.size(), 2U);
  const auto space = std::make_unique<HapticSpace>();
  const ReplayResult result = replayLoop(
      *loop, log,
      [&](const RecordedScene& scene) -> const HapticSpace& {
        fill(*space, window, {1, 1}, scene.kind, scene.anchor);
        space->scene_id = scene.id;
        EXPECT_EQ(sceneChecksum(*space), scene.checksum);
        return *space;
      },
      [](const HapticSample&, double) {});
  EXPECT_GT(result.ticks, 500U);
  EXPECT_EQ(result.different, 0U) << (result.first ? result.first->column : "");
}

TEST(LoopSession, ASurfaceThatCannotBePreparedIsTold) {
  const test::PrivateHome home;
  LoopSession session("mouse");
  SceneMaps maps;
  maps.firmness.assign(3, 1.0F);  // 200 by 200 are needed.
  session.show(flatWindow(7), SurfaceKind::crease_aware, std::move(maps));
  std::string problem;
  ASSERT_TRUE(eventually([&] {
    session.update();
    problem = session.takeProblem();
    return !problem.empty();
  }));
  EXPECT_EQ(session.takeProblem(), "") << "once";
  session.show(flatWindow(8), SurfaceKind::crease_aware);
  EXPECT_TRUE(eventually([&] { return session.update().window_id == 8; }));
}

}  // namespace
}  // namespace relievo

int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  const QCoreApplication app(argc, argv);
  return RUN_ALL_TESTS();
}
