// SPDX-License-Identifier: BSD-3-Clause
// The thread: starts, ticks, fades, joins, and says what the system refused. No timed assertions.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <thread>

#include "core/base/error.h"
#include "haptics/device/mouse_device.h"
#include "haptics/device/scripted_device.h"
#include "haptics/loop/haptic_loop.h"
#include "haptics/record/sample_drain.h"
#include "tests/haptics/haptic_fixture.h"

namespace relievo {
namespace {

void showFlat(HapticLoop& loop, std::uint64_t id) {
  loop.spaces().write(*test::spaceOf(
      80, [](double, double) { return 0.0; }, id));
}

/// Takes samples until one satisfies something.
template <class Holds>
HapticSample waitFor(HapticLoop& loop, const Holds& holds) {
  HapticSample sample;
  for (;;) {
    if (!loop.samples().pop(sample)) {
      std::this_thread::yield();
      continue;
    }
    if (holds(sample)) return sample;
  }
}

TEST(HapticLoop, TicksWithTheNewestWindowAndJoins) {
  auto device = std::make_unique<MouseDevice>();
  MouseDevice* mouse = device.get();
  HapticLoop loop(std::move(device));
  showFlat(loop, 3);
  mouse->placeAt({0, 0, 10});
  loop.start();
  loop.start();  // Already running.
  EXPECT_EQ(loop.device().id, "mouse");
  waitFor(loop, [](const HapticSample& s) { return s.window_id == 3 && !s.contact; });
  mouse->moveTo({0, 0, -2});
  const HapticSample touched =
      waitFor(loop, [](const HapticSample& s) { return s.contact && s.hip.z < -1.99; });
  EXPECT_NEAR(touched.proxy.z, 0, 1e-9);
  EXPECT_EQ(touched.force, DeviceN{}) << "forces were not asked for";
  showFlat(loop, 4);
  waitFor(loop, [](const HapticSample& s) { return s.window_id == 4; });
  loop.stop();
  loop.stop();
  EXPECT_TRUE(loop.stats().update());
  const LoopStats stats = loop.stats().front();
  EXPECT_GT(stats.ticks, 0U);
  EXPECT_LE(stats.late_ticks, stats.ticks);
  std::uint64_t in_histogram = 0;
  for (const std::uint64_t count : stats.delays) in_histogram += count;
  EXPECT_EQ(in_histogram, stats.ticks);
}

TEST(HapticLoop, NumbersItsTicksWithoutGapsAndNeverTicksTwiceForAMissedPeriod) {
  HapticLoop loop(std::make_unique<MouseDevice>());
  loop.start();
  HapticSample last = waitFor(loop, [](const HapticSample&) { return true; });
  for (int i = 0; i < 300; ++i) {
    const HapticSample next = waitFor(loop, [](const HapticSample&) { return true; });
    ASSERT_EQ(next.tick, last.tick + 1);
    // Ticks lie on a grid of absolute times: even after a late one at most one fits in a period.
    if (i > 0) {
      EXPECT_GT(next.time_ns, last.time_ns);
    }
    last = next;
  }
}

TEST(HapticLoop, FadesToZeroBeforeItStops) {
  auto device = std::make_unique<ScriptedDevice>(
      [] {
        std::vector<DeviceReading> readings(1200);  // Above the surface until forces are on.
        for (DeviceReading& reading : readings) reading.position = {0, 0, 5};
        readings.push_back({{0, 0, -6}, 0, 0});
        return readings;
      }(),
      8);
  const ScriptedDevice* script = device.get();
  HapticLoop loop(std::move(device));
  showFlat(loop, 5);
  HapticOptions options;
  options.force.forces_on = true;
  options.force.strength = 1;
  loop.options().write(options);
  loop.start();
  waitFor(loop, [](const HapticSample& s) { return s.force.z > 4; });
  loop.stop();
  EXPECT_EQ(script->lastForce(), DeviceN{});
  DeviceN before;
  bool first = true, reached_zero = false;
  for (HapticSample s; loop.samples().pop(s); first = false) {
    if (!first) {
      EXPECT_LE(norm(s.force - before), 0.2 + 1e-9) << "no kick";
    }
    before = s.force;
    reached_zero = s.force == DeviceN{};
  }
  EXPECT_TRUE(reached_zero);
}

/// Blocks once, as a stalled machine does.
class StallingDevice : public ScriptedDevice {
 public:
  StallingDevice() : ScriptedDevice({{{0, 0, 5}, 0, 0}}) {}
  DeviceReading exchange(DeviceN force, std::int64_t now_ns) RELIEVO_REALTIME override {
    if (++calls_ == 20) sleepUntil(monotonicNs() + 40'000'000);
    return ScriptedDevice::exchange(force, now_ns);
  }

 private:
  int calls_ = 0;
};

TEST(HapticLoop, CountsAStallAsLateAndDoesNotMakeUpForIt) {
  HapticLoop loop(std::make_unique<StallingDevice>());
  loop.start();
  const HapticSample before = waitFor(loop, [](const HapticSample& s) { return s.tick == 19; });
  const HapticSample after = waitFor(loop, [](const HapticSample& s) { return s.tick == 20; });
  EXPECT_GE(after.time_ns - before.time_ns, 40'000'000) << "no tick of the stall is made up for";
  loop.stop();
  loop.stats().update();
  EXPECT_GE(loop.stats().front().worst_period_ms, 40);
}

TEST(HapticLoop, RefusesToRunWithoutADevice) {
  EXPECT_THROW(HapticLoop(nullptr), ArgumentError);
  EXPECT_THROW(HapticLoop(std::make_unique<MouseDevice>(), {0, 0}), ArgumentError);
}

TEST(HapticLoop, ReportsButtonEdges) {
  auto device = std::make_unique<ScriptedDevice>(
      std::vector<DeviceReading>{{{}, 0, 0}, {{}, 0b101, 0}, {{}, 0b001, 0}});
  HapticLoop loop(std::move(device));
  loop.start();
  waitFor(loop, [](const HapticSample& s) { return s.tick > 4; });
  loop.stop();
  std::vector<std::pair<int, bool>> edges;
  for (ButtonEvent event; loop.buttons().pop(event);) edges.emplace_back(event.button, event.down);
  EXPECT_EQ(edges, (std::vector<std::pair<int, bool>>{{0, true}, {2, true}, {2, false}}));
}

/// What an ordinary user without limits of his own is told. Runs in a child process.
std::string refusalAsAnOrdinaryUser() {
  std::array<int, 2> pipe_ends{};
  if (::pipe(pipe_ends.data()) != 0) return "no pipe";
  const pid_t child = ::fork();
  if (child == 0) {
    const rlimit none{0, 0};
    bool ordinary = ::setrlimit(RLIMIT_RTPRIO, &none) == 0;
    if (::geteuid() == 0) {
      constexpr uid_t kNobody = 65534;
      ordinary = ordinary && ::setgid(kNobody) == 0 && ::setuid(kNobody) == 0;
    }
    std::string said = "the child could not become an ordinary user";
    if (ordinary) {
      const RealtimeGrant grant = requestRealtime(80, {});
      said = grant.realtime ? "GRANTED" : grant.note;
    }
    [[maybe_unused]] const ssize_t written = ::write(pipe_ends[1], said.data(), said.size());
    ::_exit(0);
  }
  ::close(pipe_ends[1]);
  std::string said(2000, '\0');
  const ssize_t count = ::read(pipe_ends[0], said.data(), said.size());
  said.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
  ::close(pipe_ends[0]);
  ::waitpid(child, nullptr, 0);
  return said;
}

TEST(Realtime, ARefusalToAnOrdinaryUserIsSaidInWords) {
  const std::string said = refusalAsAnOrdinaryUser();
  EXPECT_NE(said.find("Real-time priority was refused"), std::string::npos) << said;
  EXPECT_NE(said.find("rtprio"), std::string::npos) << "and what helps: " << said;
}

TEST(Realtime, TheLoopReportsWhatItWasGranted) {
  HapticLoop loop(std::make_unique<MouseDevice>());
  loop.start();
  const RealtimeGrant grant = loop.realtime();
  loop.stop();
  EXPECT_NE(grant.realtime && grant.memory_locked, !grant.note.empty())
      << "a note exactly where something was refused: " << grant.note;
  HapticLoop modest(std::make_unique<MouseDevice>(), {1'000'000, 0});
  modest.start();
  EXPECT_FALSE(modest.realtime().realtime);
  EXPECT_FALSE(modest.realtime().note.empty());
  modest.stop();
}

}  // namespace
}  // namespace relievo
