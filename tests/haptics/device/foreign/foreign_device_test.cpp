// SPDX-License-Identifier: BSD-3-Clause
// A device of a plug-in, in a process of its own: what comes back, what is pushed, and that
// whatever the plug-in does, the program lives and the force is off.
#include "haptics/device/foreign/foreign_device.h"

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdio>
#include <fstream>
#include <optional>
#include <utility>

#include "core/base/error.h"
#include "tests/haptics/device/foreign/foreign_fixture.h"

namespace relievo::foreign {
namespace {

using test::deviceOf;
using test::exchangeUntil;
using test::StandInEntry;
using testing::HasSubstr;

bool isGone(int pid) {
  return ::kill(pid, 0) != 0;
}

class ForeignDeviceTest : public test::ForeignTest {
 protected:
  /// What the error says that opening throws.
  static std::string refusal(Device& device) {
    try {
      device.open();
    } catch (const DeviceError& error) {
      return error.what();
    }
    return "it was opened";
  }
  /// The last step before it was closed the first time is one at zero, or its force was cut.
  void expectZeroBeforeTheClose() const {
    const auto all = log();
    const auto closed = std::find_if(all.begin(), all.end(), [](const StandInEntry& entry) {
      return entry.what == StandInEntry::What::close;
    });
    ASSERT_NE(closed, all.end());
    ASSERT_NE(closed, all.begin());
    EXPECT_NE((closed - 1)->what, StandInEntry::What::close);
    EXPECT_EQ((closed - 1)->force_n, 0) << "before it was closed";
    for (auto entry = closed; entry != all.end(); ++entry) EXPECT_EQ(entry->force_n, 0);
  }
  bool hasPushed(double least_n) const {
    const auto all = log();
    return !all.empty() && all.back().what == StandInEntry::What::step &&
           all.back().force_n >= least_n;
  }
};

TEST_F(ForeignDeviceTest, TellsPlaceButtonsAndLimits) {
  const auto device = deviceOf("none");
  device->open();
  DeviceReading last;
  exchangeUntil(*device, {}, [&](const DeviceReading& reading) {
    last = reading;
    return reading.fault == DeviceFault::none && reading.buttons != 0;
  });
  EXPECT_EQ(last.position.x, 1);
  EXPECT_EQ(last.position.y, 2);
  EXPECT_EQ(last.position.z, 3);
  EXPECT_EQ(last.buttons, 1U);
  const DeviceInfo& info = device->info();
  EXPECT_EQ(info.max_force_n, kMostForceN) << "it says 9 N of itself";
  EXPECT_EQ(info.max_stiffness_n_per_mm, 1.25);
  EXPECT_EQ(info.workspace.half_extent.x, 40);
  EXPECT_FALSE(info.simulated) << "nobody knows";
}

/// By a button that is held a hand asks for the force back.
TEST_F(ForeignDeviceTest, ButtonsArriveWhileItShowsNoForce) {
  const auto device = deviceOf("takes_force");
  device->open();
  exchangeUntil(*device, {},
                [](const DeviceReading& reading) { return reading.fault == DeviceFault::none; });
  std::ofstream(logFile() + ".takes") << "now";
  exchangeUntil(*device, {}, [](const DeviceReading& reading) {
    return reading.fault == DeviceFault::not_ready && reading.buttons == 0;
  });
  std::ofstream(logFile() + ".holds") << "now";
  exchangeUntil(*device, {}, [](const DeviceReading& reading) {
    return reading.fault == DeviceFault::not_ready && reading.buttons == 0b100;
  });
  std::filesystem::remove(logFile() + ".holds");
  exchangeUntil(*device, {}, [](const DeviceReading& reading) {
    return reading.fault == DeviceFault::not_ready && reading.buttons == 0;
  });
}

TEST_F(ForeignDeviceTest, AButtonThatIsHeldWhileItIsOpenedCountsOnceItWasLetGo) {
  std::ofstream(logFile() + ".holds") << "before";
  const auto device = deviceOf("takes_force");
  device->open();
  const auto buttonsFor = [&](int rounds) {
    std::uint32_t seen = 0;
    const std::size_t before = log().size();
    exchangeUntil(*device, {}, [&](const DeviceReading& reading) {
      seen |= reading.buttons;
      return log().size() > before + static_cast<std::size_t>(rounds);
    });
    return seen;
  };
  EXPECT_EQ(buttonsFor(20), 0U);
  std::filesystem::remove(logFile() + ".holds");
  EXPECT_EQ(buttonsFor(20), 0U);
  std::ofstream(logFile() + ".holds") << "again";
  EXPECT_EQ(buttonsFor(20), 0b100U);
}

TEST_F(ForeignDeviceTest, AForceIsNeverAboveTheLimit) {
  const auto device = deviceOf("none");
  device->open();
  exchangeUntil(*device, {0, 0, 100}, [&](const DeviceReading&) { return hasPushed(5.999); });
  for (const StandInEntry& entry : log()) EXPECT_LE(entry.force_n, kMostForceN + 1e-9);
}

TEST_F(ForeignDeviceTest, WithoutAWatchdogOfItsOwnItPushesLess) {
  const auto device = deviceOf("weak");
  device->open();
  EXPECT_EQ(device->info().max_force_n, kMostForceWithoutWatchdogN);
  exchangeUntil(*device, {0, 0, 100}, [&](const DeviceReading&) { return hasPushed(1.999); });
  for (const StandInEntry& entry : log()) {
    EXPECT_LE(entry.force_n, kMostForceWithoutWatchdogN + 1e-9);
  }
}

TEST_F(ForeignDeviceTest, ClosingSendsZeroAndTheHostGoes) {
  const auto device = deviceOf("none");
  device->open();
  const int host = device->hostPid();
  exchangeUntil(*device, {0, 0, 3}, [&](const DeviceReading&) { return hasPushed(1); });
  device->close();
  EXPECT_TRUE(isGone(host));
  expectZeroBeforeTheClose();
}

/// What its motors can show for good is held to, also where more is possible for a moment.
TEST_F(ForeignDeviceTest, MotorsThatWarmGetLess) {
  const auto device = deviceOf("warms");
  device->open();
  std::optional<HeatReport> heat;
  exchangeUntil(*device, {0, 0, 6}, [&](const DeviceReading&) {
    heat = device->heat();
    return heat && heat->used > 0.75;
  });
  EXPECT_LT(heat->allowed_n, 4);
  EXPECT_GE(heat->allowed_n, 1);
  EXPECT_LT(log().back().force_n, 4);
}

TEST_F(ForeignDeviceTest, AMotorAtItsLimitIsNotPushed) {
  const auto device = deviceOf("hot");
  device->open();
  exchangeUntil(*device, {0, 0, 3}, [](const DeviceReading& reading) {
    return reading.fault == DeviceFault::overheated;
  });
  const std::size_t before = log().size();
  exchangeUntil(*device, {0, 0, 3},
                [&](const DeviceReading&) { return log().size() > before + 20; });
  const auto all = log();
  for (std::size_t i = before + 2; i < all.size(); ++i) EXPECT_EQ(all[i].force_n, 0) << i;
}

/// Whatever happens to its file between the look and the opening.
TEST_F(ForeignDeviceTest, WhatWasJudgedIsWhatRuns) {
  const std::filesystem::path file = folder / "mine.so";
  std::filesystem::copy_file(test::standIn("none"), file);
  PluginImage judged = readPlugin(file);
  std::filesystem::copy_file(test::standIn("open_fails"), file,
                             std::filesystem::copy_options::overwrite_existing);
  ForeignDevice device(std::move(judged), test::kStandInId, "plugin:mine/x", "Stand-in",
                       test::longPatience());
  device.open();
  device.close();
  ForeignDevice other(readPlugin(file), test::kStandInId, "plugin:mine/x", "Stand-in");
  EXPECT_THAT(refusal(other), HasSubstr("another program holds it"));
}

TEST_F(ForeignDeviceTest, AProgramThatAPlugInStartsHasNoneOfItsDescriptors) {
  const auto device = deviceOf("starts_program");
  device->open();
  std::ifstream stream(logFile() + ".descriptors");
  std::string line;
  ASSERT_TRUE(std::getline(stream, line));
  EXPECT_EQ(line, "end");
}

/// To be given its priority may take a guard a second: until it looks nothing is loaded that can
/// push.
TEST_F(ForeignDeviceTest, NothingIsOpenedBeforeItsGuardLooks) {
  const auto device = deviceOf("wants_guard");
  device->open();
}

TEST_F(ForeignDeviceTest, AnOpeningIsGivenUp) {
  const auto device = deviceOf("open_hangs", {.open_s = 120, .close_ms = 100});
  device->giveUp();
  EXPECT_THAT(refusal(*device), HasSubstr("was not opened"));
}

TEST_F(ForeignDeviceTest, OpensAgain) {
  const auto device = deviceOf("none");
  for (int i = 0; i < 2; ++i) {
    device->open();
    exchangeUntil(*device, {}, [](const DeviceReading& r) { return r.fault == DeviceFault::none; });
    device->close();
  }
}

TEST_F(ForeignDeviceTest, ACutIsZeroUntilAForceIsMadeAfterIt) {
  const auto device = deviceOf("none");
  device->open();
  exchangeUntil(*device, {0, 0, 3}, [&](const DeviceReading&) { return hasPushed(1); });
  const std::size_t before = log().size();
  device->cutForce();
  // No reading is taken after the cut: what is ordered was begun before it.
  const auto cutAndZero = [this, before] {
    const auto all = log();
    bool cut = false;
    for (std::size_t i = before; i < all.size(); ++i) {
      cut = cut || all[i].what == StandInEntry::What::cut;
      if (cut && all[i].what == StandInEntry::What::step && all[i].force_n == 0) return true;
    }
    return false;
  };
  while (!cutAndZero()) {
    device->send({0, 0, 3}, monotonicNs());
    sleepUntil(monotonicNs() + 1'000'000);
  }
  EXPECT_FALSE(hasPushed(1));
  exchangeUntil(*device, {0, 0, 3}, [&](const DeviceReading&) { return hasPushed(1); });
}

TEST_F(ForeignDeviceTest, OrdersThatStopAreZero) {
  const auto device = deviceOf("none");
  device->open();
  exchangeUntil(*device, {0, 0, 3}, [&](const DeviceReading&) { return hasPushed(1); });
  while (hasPushed(1e-9)) sleepUntil(monotonicNs() + 1'000'000);
}

TEST_F(ForeignDeviceTest, SaysWhyItIsNotOpened) {
  const std::vector<std::pair<const char*, const char*>> cases{
      {"other_major", "made for version 9 of the interface"},
      {"short_table", "lacks a function"},
      {"null_function", "lacks a function"},
      {"init_fails", "could not begin (status -10)"},
      {"open_fails", "its plug-in says: another program holds it"},
      {"no_limits", "impossible"}};
  for (const auto& [fault, says] : cases) {
    EXPECT_THAT(refusal(*deviceOf(fault)), HasSubstr(says)) << fault;
  }
  ForeignDevice nobody(test::standIn("none"), "stand-in.8", "plugin:none/stand-in.8", "Stand-in");
  EXPECT_THAT(refusal(nobody), HasSubstr("knows no device of this name"));
  ForeignDevice no_file(folder / "none.so", test::kStandInId, "plugin:x/y", "Stand-in");
  EXPECT_THAT(refusal(no_file), HasSubstr("cannot be loaded"));
}

TEST_F(ForeignDeviceTest, WhatHangsAtItsOpeningIsGivenUp) {
  const auto device = deviceOf("open_hangs", {.open_s = 1, .close_ms = 100});
  EXPECT_THAT(refusal(*device), HasSubstr("was not ready within 1 second"));
}

struct Lost {
  const char* fault;
  DeviceFault told;
};
class ForeignDeviceFaults : public ForeignDeviceTest, public testing::WithParamInterface<Lost> {};

TEST_P(ForeignDeviceFaults, AreToldAndTheProgramLives) {
  const auto device = deviceOf(GetParam().fault);
  device->open();
  exchangeUntil(*device, {0, 0, 3},
                [](const DeviceReading& reading) { return reading.fault == GetParam().told; });
}

INSTANTIATE_TEST_SUITE_P(All, ForeignDeviceFaults,
                         testing::Values(Lost{"nan_place", DeviceFault::protocol},
                                         Lost{"far_place", DeviceFault::protocol},
                                         Lost{"frozen_time", DeviceFault::protocol},
                                         Lost{"future", DeviceFault::protocol},
                                         Lost{"throws", DeviceFault::protocol},
                                         Lost{"crashes", DeviceFault::disconnected},
                                         Lost{"aborts", DeviceFault::disconnected},
                                         Lost{"ends_process", DeviceFault::disconnected},
                                         Lost{"loses_device", DeviceFault::disconnected}),
                         [](const auto& tested) { return std::string(tested.param.fault); });

TEST_F(ForeignDeviceTest, AfterAFaultTheForceIsZero) {
  const auto device = deviceOf("nan_place");
  device->open();
  exchangeUntil(*device, {0, 0, 3}, [](const DeviceReading& reading) {
    return reading.fault == DeviceFault::protocol;
  });
  const std::size_t before = log().size();
  exchangeUntil(*device, {0, 0, 3},
                [&](const DeviceReading&) { return log().size() > before + 20; });
  const auto all = log();
  for (std::size_t i = before + 2; i < all.size(); ++i) EXPECT_EQ(all[i].force_n, 0) << i;
}

TEST_F(ForeignDeviceTest, AStepThatHangsIsCutAndItsHostKilled) {
  auto patience = test::longPatience();
  patience.silence_ms = 1000;
  const auto device = deviceOf("hangs", patience);
  device->open();
  const int host = device->hostPid();
  exchangeUntil(*device, {0, 0, 3}, [&](const DeviceReading&) { return isGone(host); });
  const std::int64_t gone_ns = monotonicNs();
  EXPECT_EQ(device->read(monotonicNs()).fault, DeviceFault::timeout);
  const auto all = log();
  ASSERT_FALSE(all.empty());
  EXPECT_EQ(all.back().what, StandInEntry::What::cut) << "by the guard, while it hung";
  const auto step = std::find_if(all.rbegin(), all.rend(), [](const StandInEntry& entry) {
    return entry.what == StandInEntry::What::step;
  });
  ASSERT_NE(step, all.rend());
  ASSERT_NE(step, all.rbegin());
  // Once as it was overdue and once as relievo let it go. A third would be the last one of a host
  // that waited for all of its time to close what cannot be closed.
  EXPECT_EQ(step - all.rbegin(), 2);
  // Figures for docs/dev/device-evidence.md, no promise of a busy computer.
  std::printf("cut %.2f ms after the step began, host gone %.2f ms after the %d ms it is given\n",
              1e-6 * static_cast<double>((step - 1)->time_ns - step->time_ns),
              1e-6 * static_cast<double>(gone_ns - step->time_ns) - patience.silence_ms,
              patience.silence_ms);
}

TEST_F(ForeignDeviceTest, APlaceThatStaysOldIsATimeout) {
  auto patience = test::longPatience();
  patience.stale_place_ns = 0;  // Any age is too old.
  const auto device = deviceOf("none", patience);
  device->open();
  exchangeUntil(*device, {},
                [](const DeviceReading& r) { return r.fault == DeviceFault::timeout; });
}

TEST_F(ForeignDeviceTest, AHostThatDoesNotGoIsKilled) {
  const auto device = deviceOf("close_hangs", {.close_ms = 50});
  device->open();
  const int host = device->hostPid();
  device->close();
  EXPECT_TRUE(isGone(host));
}

/// Killed as by SIGKILL nothing can be sent by the program itself: its host does.
TEST_F(ForeignDeviceTest, AProgramThatIsKilledLeavesZeroAndNoHost) {
  // What the program leaves behind becomes ours, so that its end is seen.
  ASSERT_EQ(::prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0), 0);
  std::array<int, 2> pipe{};
  ASSERT_EQ(::pipe(pipe.data()), 0);
  const std::string client = std::string(RELIEVO_BINARY_DIR) + "/tests/foreign_client";
  const std::string plugin = test::standIn("none");
  const pid_t program = ::fork();
  if (program == 0) {
    ::dup2(pipe[1], 1);
    ::execl(client.c_str(), client.c_str(), plugin.c_str(), test::kStandInId, nullptr);
    ::_exit(127);
  }
  ::close(pipe[1]);
  FILE* const said = ::fdopen(pipe[0], "r");
  int host = 0;
  ASSERT_EQ(std::fscanf(said, "%d", &host), 1);
  while (!hasPushed(2.999)) sleepUntil(monotonicNs() + 1'000'000);
  const std::int64_t killed_ns = monotonicNs();
  ASSERT_EQ(::kill(program, SIGKILL), 0);
  ::waitpid(program, nullptr, 0);
  ASSERT_EQ(::waitpid(host, nullptr, 0), host);
  const std::int64_t gone_ns = monotonicNs();
  std::fclose(said);
  expectZeroBeforeTheClose();
  const auto all = log();
  std::int64_t last_push_ns = 0;
  for (const StandInEntry& entry : all) {
    if (entry.force_n > 0) last_push_ns = entry.time_ns;
  }
  // A figure for docs/adr/0157, no promise of a busy computer.
  std::printf("last force %.2f ms after the kill, its host gone after %.2f ms\n",
              1e-6 * static_cast<double>(last_push_ns - killed_ns),
              1e-6 * static_cast<double>(gone_ns - killed_ns));
}

}  // namespace
}  // namespace relievo::foreign
