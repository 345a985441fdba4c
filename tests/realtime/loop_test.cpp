// SPDX-License-Identifier: BSD-3-Clause
// The thread: starts, ticks, fades, joins, and says what the system refused. No timed assertions.
#include <gtest/gtest.h>
#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <map>
#include <string>
#include <thread>
#include <vector>

#include "core/base/error.h"
#include "haptics/device/mouse_device.h"
#include "haptics/device/scripted_device.h"
#include "haptics/device/virtual_hand.h"
#include "haptics/loop/haptic_loop.h"
#include "haptics/loop/watchdog.h"
#include "haptics/record/sample_drain.h"
#include "tests/haptics/haptic_fixture.h"

namespace relievo {
namespace {

void showFlat(HapticLoop& loop, std::uint64_t id) {
  loop.spaces().write(*test::spaceOf(
      80, [](double, double) { return 0.0; }, id));
}

/// Takes samples until one satisfies something; the last one, and a failure, where none does.
template <class Holds>
HapticSample waitFor(HapticLoop& loop, const Holds& holds) {
  constexpr std::int64_t kLimitNs = 60'000'000'000;
  HapticSample sample;
  for (const std::int64_t give_up = monotonicNs() + kLimitNs; monotonicNs() < give_up;) {
    if (!loop.samples().pop(sample)) {
      std::this_thread::yield();
      continue;
    }
    if (holds(sample)) return sample;
  }
  ADD_FAILURE() << "No sample was as awaited.";
  return sample;
}

/// How often each thread of this process has slept, by its number.
std::map<std::string, std::uint64_t> sleepsOfThreads() {
  std::map<std::string, std::uint64_t> sleeps;
  for (const auto& thread : std::filesystem::directory_iterator("/proc/self/task")) {
    std::ifstream status(thread.path() / "status");
    const std::string wanted = "voluntary_ctxt_switches:";
    for (std::string line; std::getline(status, line);) {
      if (line.starts_with(wanted)) {
        sleeps[thread.path().filename()] = std::stoull(line.substr(wanted.size()));
      }
    }
  }
  return sleeps;
}

/// On a computer that is so busy that every sleep ends late the force is cut all the same.
TEST(HapticLoop, AWatchdogThatAlwaysWakesLateFindsAStall) {
  constexpr std::int64_t kLook = Watchdog::kLookNs, kStall = Watchdog::kStallNs;
  for (const std::int64_t late : {std::int64_t{0}, kLook / 2, kLook, 3 * kLook, 20 * kLook}) {
    constexpr std::int64_t kBeat = 1;  // Of a loop that stands still from here on.
    std::int64_t now = kBeat, look = now, cut = 0;
    for (int looks = 0; looks < 100 && cut == 0; ++looks) {
      look += kLook;
      if (look > now) now = look + late;
      const bool came_late = now - look >= kLook;
      if (!came_late && now - kBeat > kStall) cut = now;
      look = Watchdog::lookAfter(now, came_late, kBeat);
    }
    EXPECT_GT(cut, kBeat + kStall) << late;
    EXPECT_LE(cut, kBeat + kStall + kLook + 2 * late) << late;
  }
}

TEST(HapticLoop, TheWatchdogSleepsUntilAHeartbeatCouldBeTooOld) {
  const auto others = sleepsOfThreads();
  HapticLoop loop(std::make_unique<MouseDevice>());
  loop.start();
  waitFor(loop, [](const HapticSample&) { return true; });  // Before there is nothing to watch.
  const std::int64_t start_ns = monotonicNs();
  const auto before = sleepsOfThreads();
  constexpr int kTicks = 1000;
  int ticks = 0;
  waitFor(loop, [&ticks](const HapticSample&) { return ++ticks == kTicks; });
  std::vector<std::uint64_t> sleeps;
  for (const auto& [thread, count] : sleepsOfThreads()) {
    if (others.contains(thread)) continue;
    const auto earlier = before.find(thread);
    sleeps.push_back(count - (earlier == before.end() ? 0 : earlier->second));
  }
  const double ran_ms = 1e-6 * static_cast<double>(monotonicNs() - start_ns);
  loop.stop();
  // The loop's sleeps most, the watchdog's next; the thread sanitizer may have begun one of its
  // own.
  ASSERT_GE(sleeps.size(), 2U);
  std::sort(sleeps.rbegin(), sleeps.rend());
  // One in 16 ms; by looks of 2 ms it was one in two. By the clock, as it sleeps: a loop that comes
  // late has fewer ticks in the same time.
  EXPECT_LT(static_cast<double>(sleeps[1]), ran_ms / 5);
  EXPECT_GT(sleeps[1], 0U);
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
  std::uint64_t worked = 0;
  for (const std::uint64_t count : stats.work) worked += count;
  EXPECT_EQ(worked, stats.ticks);
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

HapticOptions fullForces() {
  HapticOptions options;
  options.force.forces_on = true;
  options.force.strength = 1;
  options.bound_by_rate = false;  // A busy computer would have its say in every force (E306).
  return options;
}

/// Above the surface until forces are on, then pressed in.
std::vector<DeviceReading> pressAfterRising() {
  std::vector<DeviceReading> readings(1200);
  for (DeviceReading& reading : readings) reading.position = {0, 0, 5};
  readings.push_back({{0, 0, -6}, 0, 0});
  return readings;
}

TEST(HapticLoop, SendsZeroInTheVeryTickInWhichItStops) {
  auto device = std::make_unique<ScriptedDevice>(pressAfterRising(), 8);
  const ScriptedDevice* script = device.get();
  HapticLoop loop(std::move(device));
  showFlat(loop, 5);
  loop.options().write(fullForces());
  loop.start();
  waitFor(loop, [](const HapticSample& s) { return s.force.z > 4; });
  loop.stop();
  EXPECT_EQ(script->lastForce(), DeviceN{});
  HapticSample last;
  for (HapticSample s; loop.samples().pop(s);) last = s;
  EXPECT_EQ(last.force, DeviceN{});
  EXPECT_EQ(last.engaged, EngagePhase::off);
}

TEST(HapticLoop, SendsZeroInTheFirstTickAfterForcesAreSwitchedOff) {
  HapticLoop loop(std::make_unique<ScriptedDevice>(pressAfterRising(), 8));
  showFlat(loop, 6);
  HapticOptions options = fullForces();
  loop.start();
  HapticSample before, off;
  // Again where a pause of the whole computer took the force a moment earlier.
  for (int tries = 0; tries < 100 && before.force.z <= 4; ++tries) {
    options.force.forces_on = true;
    loop.options().write(options);
    before = waitFor(loop, [](const HapticSample& s) { return s.force.z > 4; });
    options.force.forces_on = false;
    loop.options().write(options);
    off = waitFor(loop, [&before](const HapticSample& s) {
      if (s.engaged == EngagePhase::off) return true;
      before = s;
      return false;
    });
    ASSERT_EQ(off.force, DeviceN{});
  }
  EXPECT_GT(before.force.z, 4);
  loop.stop();
  loop.stats().update();
  const ForceAudit& audit = loop.stats().front().audit;
  EXPECT_EQ(audit.violations(), 0U);
  EXPECT_GT(audit.zero_demanded, 0U);
  EXPECT_LT(audit.zero_demanded, audit.ticks);
}

/// A device as a person would hold it.
class Held : public Device {
 public:
  Held() {
    info_.id = info_.name = "held";
    info_.max_force_n = 5;
  }
  const DeviceInfo& info() const noexcept override { return info_; }
  void open() override {}
  void close() noexcept override {}
  void send(DeviceN, std::int64_t) RELIEVO_REALTIME override {}
  DeviceReading read(std::int64_t now_ns) RELIEVO_REALTIME override {
    return {{}, 0, now_ns, DeviceFault::none};
  }

 private:
  DeviceInfo info_;
};

/// Blocks once while it sends a force, as a stuck bus does, and remembers the calls.
class StuckDevice : public ScriptedDevice {
 public:
  StuckDevice() : ScriptedDevice(pressAfterRising(), 8) {}
  void send(DeviceN force, std::int64_t now_ns) RELIEVO_REALTIME override {
    if (after_stall_ == 0) {
      first_ = force;
      after_stall_ = 1;
    }
    if (force.z > 4 && after_stall_ < 0) {
      const std::int64_t give_up_ns = monotonicNs() + 60'000'000'000;
      // On a busy computer the watchdog may have come in an earlier tick as well.
      const int cuts_before = cuts_.load();
      // Until the watchdog has come: the stall is as long as it takes, not as long as a guess.
      while (cuts_.load() == cuts_before && monotonicNs() < give_up_ns) {
        sleepUntil(monotonicNs() + 1'000'000);
      }
      stalled_ns_ = monotonicNs() - now_ns;
      sleepUntil(now_ns + 40'000'000);
      sleepUntil(monotonicNs() + 10'000'000);  // Five more looks of the watchdog at least.
      cuts_of_stall_ = cuts_.load() - cuts_before;
      after_stall_ = 0;
      stall_over_.store(true);
    }
    ScriptedDevice::send(force, now_ns);
  }
  void cutForce() noexcept override { cuts_.fetch_add(1); }
  bool wasCut() const { return cuts_.load() > 0; }
  bool stallIsOver() const { return stall_over_.load(); }

  // [loop stopped]
  int cutsOfTheStall() const { return cuts_of_stall_; }
  DeviceN firstAfterStall() const { return first_; }
  std::int64_t stalledNs() const { return stalled_ns_; }

 private:
  std::atomic<bool> stall_over_{false};
  std::atomic<int> cuts_{0};
  int cuts_of_stall_ = 0;
  int after_stall_ = -1;  // -1: no stall yet, 0: just over, 1: past.
  DeviceN first_{1, 1, 1};
  std::int64_t stalled_ns_ = 0;
};

TEST(HapticLoop, AWatchdogCutsTheForceOfAStuckExchangeAndTheNextFrameIsZero) {
  auto device = std::make_unique<StuckDevice>();
  const StuckDevice* stuck = device.get();
  HapticLoop loop(std::move(device));
  showFlat(loop, 8);
  loop.options().write(fullForces());
  loop.start();
  // A pause of the whole computer resumes as well: the one after the stall is meant.
  const HapticSample resumed =
      waitFor(loop, [stuck](const HapticSample& s) { return s.resumed && stuck->stallIsOver(); });
  EXPECT_EQ(resumed.force, DeviceN{}) << "the force computed next is zero, too";
  EXPECT_EQ(resumed.engaged, EngagePhase::rising);
  DeviceN before;
  std::int64_t last_ns = resumed.time_ns;
  for (int i = 0; i < 50; ++i) {
    const HapticSample s = waitFor(loop, [](const HapticSample&) { return true; });
    last_ns = s.time_ns;
    if (!s.resumed) {
      EXPECT_LE(norm(s.force - before), 0.02 + 1e-9) << "and rises gently";
    }
    before = s.force;
  }
  // Each tick waits for its own deadline on the grid: what was missed is not made up in a burst.
  EXPECT_GE(last_ns - resumed.time_ns, 49'000'000 - 1'000'000);
  loop.stop();
  EXPECT_TRUE(stuck->wasCut());
  EXPECT_EQ(stuck->cutsOfTheStall(), 1) << "one cut per stall";
  EXPECT_GE(stuck->stalledNs(), Watchdog::kStallNs) << "not before it was a stall";
  EXPECT_EQ(stuck->firstAfterStall(), DeviceN{});
  loop.stats().update();
  const LoopStats stats = loop.stats().front();
  EXPECT_GE(stats.watchdog_cuts, 1U);
  EXPECT_GE(stats.pauses, 1U);
  EXPECT_GE(stats.worst_period_ms, 40) << "no tick of the stall is made up for";
  EXPECT_EQ(stats.audit.violations(), 0U);
}

/// Where the kernel grants priorities at all.
class Prioritized : public StuckDevice {
 public:
  DeviceReading read(std::int64_t now_ns) RELIEVO_REALTIME override {
    loop_.store(priority());
    return StuckDevice::read(now_ns);
  }
  void cutForce() noexcept override {
    watchdog_.store(priority());
    StuckDevice::cutForce();
  }
  int loopPriority() const { return loop_.load(); }
  int watchdogPriority() const { return watchdog_.load(); }

 private:
  static int priority() {
    sched_param parameters{};
    int policy = 0;
    pthread_getschedparam(pthread_self(), &policy, &parameters);
    return policy == SCHED_OTHER ? 0 : parameters.sched_priority;
  }
  std::atomic<int> loop_{0}, watchdog_{0};
};

TEST(HapticLoop, TheWatchdogIsMoreUrgentThanTheLoopThatItWatches) {
  auto device = std::make_unique<Prioritized>();
  const Prioritized* prioritized = device.get();
  HapticLoop loop(std::move(device));
  showFlat(loop, 8);
  loop.options().write(fullForces());
  loop.start();
  if (!loop.realtime().realtime) GTEST_SKIP() << loop.realtime().note;
  waitFor(loop, [&](const HapticSample&) { return prioritized->wasCut(); });
  loop.stop();
  // A loop that spins at the watchdog's own priority would never let it run.
  EXPECT_GT(prioritized->watchdogPriority(), prioritized->loopPriority());
}

TEST(HapticLoop, AWatchdogLeavesARunningLoopAlone) {
  MouseDevice mouse;
  Watchdog watchdog(mouse, 0);
  for (int i = 0; i < 50; ++i) {
    // The beats may come late on a busy machine; never by a whole stall's time before now. Nor are
    // they from a far future: a watchdog that has seen one sleeps until it could be too old.
    EXPECT_FALSE(watchdog.beat(monotonicNs() + 10'000'000'000));
    std::this_thread::yield();
  }
  EXPECT_EQ(watchdog.cuts(), 0U);
  watchdog.rest();
}

TEST(HapticLoop, TicksOnWhileItsOwnerIsBlocked) {
  HapticLoop loop(std::make_unique<MouseDevice>());
  loop.start();
  waitFor(loop, [](const HapticSample& s) { return s.tick > 5; });
  HapticSample first = waitFor(loop, [](const HapticSample&) { return true; });
  // The owner's thread does nothing at all for two seconds, as a GUI thread that hangs.
  sleepUntil(first.time_ns + 2'000'000'000);
  HapticSample last = first;
  std::uint64_t seen = 0;
  for (HapticSample s; loop.samples().pop(s); ++seen) last = s;
  loop.stop();
  EXPECT_EQ(last.tick - first.tick, seen) << "every one is there";
  // Against the loop's own clock: each period either had a tick or was skipped as missed.
  const double seconds = 1e-9 * static_cast<double>(last.time_ns - first.time_ns);
  EXPECT_GT(seconds, 1);
  EXPECT_GT(static_cast<double>(seen), 10 * seconds);
  EXPECT_LT(static_cast<double>(seen), 1001 * seconds + 2);
}

/// In contact it brings two more windows while the first new one still comes, from the loop's own
/// thread: no computer is so busy that they come too late.
class BringsWindows : public ScriptedDevice {
 public:
  BringsWindows() : ScriptedDevice(pressAfterRising(), 8) {}
  HapticLoop* loop = nullptr;
  void send(DeviceN force, std::int64_t now_ns) RELIEVO_REALTIME override {
    ScriptedDevice::send(force, now_ns);
    if (brought_ == 0 && force.z > 2) {
      bring({2});
    } else if (brought_ == 1 && ++ticks_ > 20) {
      bring({3, 4});
    }
  }

 private:
  void bring(std::initializer_list<std::uint64_t> ids) {
    for (const std::uint64_t id : ids) showFlat(*loop, id);
    ++brought_;
  }
  int brought_ = 0, ticks_ = 0;
};

TEST(HapticLoop, WhileAWindowComesTheNewestWaitsAndReplacesTheOneBeforeIt) {
  auto device = std::make_unique<BringsWindows>();
  BringsWindows& brings = *device;
  HapticLoop loop(std::move(device));
  brings.loop = &loop;
  showFlat(loop, 1);
  loop.options().write(fullForces());
  loop.start();
  std::vector<std::uint64_t> windows;
  HapticSample before;
  bool came = false, paused = false;
  waitFor(loop, [&](const HapticSample& s) {
    paused = paused || s.resumed;
    if (windows.empty() || windows.back() != s.window_id) windows.push_back(s.window_id);
    came = came || (s.window_id == 2 && s.change < 1);
    EXPECT_TRUE(s.window_id != 4 || before.window_id == 4 || before.change == 1);
    before = s;
    return s.window_id == 4 && s.change == 1;
  });
  loop.stop();
  // After a pause of the whole computer no force is felt, and a window comes at once.
  EXPECT_TRUE(came || paused) << "little by little";
  EXPECT_EQ(windows, (std::vector<std::uint64_t>{1, 2, 4}));
}

/// Presses, and holds these buttons once the hand feels the force: after a pause of the whole
/// computer forces rise anew, so a count of ticks would not do.
class HoldsWhatItFeels : public ScriptedDevice {
 public:
  explicit HoldsWhatItFeels(std::uint32_t buttons)
      : ScriptedDevice(pressAfterRising(), 8), buttons_(buttons) {}
  void send(DeviceN force, std::int64_t now_ns) RELIEVO_REALTIME override {
    if (force.z > 4) felt_ = true;
    ScriptedDevice::send(force, now_ns);
  }
  DeviceReading read(std::int64_t now_ns) RELIEVO_REALTIME override {
    DeviceReading reading = ScriptedDevice::read(now_ns);
    if (felt_) reading.buttons = buttons_;
    return reading;
  }

 private:
  std::uint32_t buttons_;
  bool felt_ = false;
};

TEST(HapticLoop, AHeldCentreStopsTheForcesWhileTheOwnerIsBlocked) {
  constexpr std::uint32_t kCentre = 1U << 2U;
  HapticLoop loop(std::make_unique<HoldsWhatItFeels>(kCentre));
  showFlat(loop, 8);
  loop.options().write(fullForces());
  loop.start();
  const HapticSample pressed =
      waitFor(loop, [](const HapticSample& s) { return s.buttons == kCentre; });
  // Nobody but the loop does anything.
  sleepUntil(pressed.time_ns + 1'700'000'000);
  std::int64_t before_ns = pressed.time_ns;
  const HapticSample zero = waitFor(loop, [&before_ns](const HapticSample& s) {
    if (s.stopped == StopReason::held) return true;
    before_ns = s.time_ns;
    return false;
  });
  loop.stop();
  EXPECT_EQ(zero.force, DeviceN{}) << "in the tick in which it has been held for so long";
  const auto since = [&](std::int64_t ns) {
    return 1e-9 * static_cast<double>(ns - pressed.time_ns);
  };
  EXPECT_GE(since(zero.time_ns), ForceStop::kHeldS);
  EXPECT_LT(since(before_ns), ForceStop::kHeldS);
  RecordProperty("press_to_zero_ms", static_cast<int>(1e3 * since(zero.time_ns)));
}

TEST(HapticLoop, ForcesFadeOutWhenTheWindowSaysNothing) {
  HapticLoop loop(std::make_unique<ScriptedDevice>(pressAfterRising(), 8));
  showFlat(loop, 8);
  HapticOptions options = fullForces();
  // Longer than a busy computer keeps this thread from running.
  options.stop.window_silence_s = 1;
  loop.options().write(options);
  loop.start();
  const auto aliveUntil = [&loop](const auto& holds) {
    return waitFor(loop, [&](const HapticSample& s) {
      loop.sayAlive();
      return holds(s);
    });
  };
  const HapticSample pressed = aliveUntil([](const HapticSample& s) { return s.force.z > 4; });
  EXPECT_EQ(pressed.stopped, StopReason::none);
  const std::int64_t before_last_word_ns = monotonicNs();
  loop.sayAlive();
  std::int64_t last_felt_ns = 0, first_ns = 0;
  constexpr std::int64_t kFadedNs = 800'000'000;
  waitFor(loop, [&](const HapticSample& s) {
    if (s.stopped == StopReason::window_silent && first_ns == 0) first_ns = s.time_ns;
    if (!(s.force == DeviceN{})) last_felt_ns = s.time_ns;
    return first_ns != 0 && s.time_ns > first_ns + kFadedNs;
  });
  loop.stop();
  EXPECT_GT(first_ns, before_last_word_ns + 1'000'000'000);
  EXPECT_GT(last_felt_ns, before_last_word_ns) << "and was felt until then";
  EXPECT_LE(last_felt_ns, first_ns + 500'000'000) << "0.5 s later it is zero";
}

TEST(HapticLoop, OnlyASimulatedDeviceGetsTheBareSpring) {
  const LoopOptions bare{.chain = ForceChain::bare};
  EXPECT_THROW(HapticLoop(std::make_unique<MouseDevice>(), bare), ArgumentError);
  EXPECT_THROW(HapticLoop(std::make_unique<Held>(), bare), ArgumentError);
  EXPECT_NO_THROW(HapticLoop(std::make_unique<VirtualHand>(), bare));
  EXPECT_NO_THROW(HapticLoop(std::make_unique<ScriptedDevice>(pressAfterRising(), 8), bare));
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
    bool ordinary =
        ::setrlimit(RLIMIT_RTPRIO, &none) == 0 && ::setrlimit(RLIMIT_MEMLOCK, &none) == 0;
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
  EXPECT_NE(said.find("RealtimeKit: "), std::string::npos) << "who else was asked: " << said;
  EXPECT_NE(said.find("rtprio"), std::string::npos) << "and what helps: " << said;
}

// Under a sanitizer every call to lock memory succeeds and locks nothing.
#if !defined(__SANITIZE_THREAD__) && !defined(__SANITIZE_ADDRESS__)
TEST(Realtime, MemoryThatCannotBeLockedIsSaidInWords) {
  const std::string said = refusalAsAnOrdinaryUser();
  EXPECT_NE(said.find("Memory could not be locked"), std::string::npos) << said;
  EXPECT_NE(said.find("0 of "), std::string::npos) << "how much: " << said;
  EXPECT_NE(said.find("memlock"), std::string::npos) << "and what helps: " << said;
}

/// A device that waits for memory in each reading: it touches a page that nobody has touched.
class FaultingDevice : public MouseDevice {
 public:
  FaultingDevice()
      : pages_(static_cast<char*>(::mmap(nullptr, kPages * kPage, PROT_READ | PROT_WRITE,
                                         MAP_PRIVATE | MAP_ANONYMOUS, -1, 0))) {
    // One fault for one page, also where the system would give larger ones.
    ::madvise(pages_, kPages * kPage, MADV_NOHUGEPAGE);
  }
  ~FaultingDevice() override { ::munmap(pages_, kPages * kPage); }
  DeviceReading read(std::int64_t now_ns) RELIEVO_REALTIME override {
    if (next_ < kPages) pages_[kPage * next_++] = 1;
    return MouseDevice::read(now_ns);
  }

 private:
  static constexpr std::size_t kPages = 100, kPage = 4096;
  char* pages_;
  std::size_t next_ = 0;
};

TEST(Realtime, PageFaultsOfTicksAreCountedAndALockedLoopHasNone) {
  const auto faults = [](std::unique_ptr<Device> device) {
    HapticLoop loop(std::move(device));
    showFlat(loop, 7);
    loop.start();
    waitFor(loop, [](const HapticSample& s) { return s.tick > 200; });
    loop.stop();
    loop.stats().update();
    return std::pair(loop.stats().front(), loop.realtime());
  };
  const auto planted = faults(std::make_unique<FaultingDevice>()).first;
  EXPECT_GE(planted.page_faults, 99U);
  EXPECT_GE(planted.faulty_ticks, 99U);
  const auto [stats, grant] = faults(std::make_unique<MouseDevice>());
  if (!grant.memory_locked) GTEST_SKIP() << grant.note;
  EXPECT_GT(grant.locked_bytes, sizeof(HapticSpace) * 4 + kStackBytes);
  EXPECT_EQ(stats.page_faults, 0U);
}
#endif

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
