// SPDX-License-Identifier: BSD-3-Clause
// However a recording ends or is interrupted: replayed, it is the same to the last bit.
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <limits>
#include <random>
#include <thread>

#include "core/base/error.h"
#include "haptics/loop/device_limits.h"
#include "haptics/loop/haptic_loop.h"
#include "haptics/record/events.h"
#include "haptics/record/loop_recording.h"
#include "haptics/record/recorded_loop.h"
#include "haptics/record/replay.h"
#include "haptics/record/sample_drain.h"
#include "tests/core/io/temporary_folder.h"
#include "tests/haptics/haptic_fixture.h"
#include "tests/haptics/record/size_limit.h"

namespace relievo {
namespace {

/// A name that is free: what stands there would stay until a log is whole.
std::filesystem::path temporary(const std::string& name) {
  const std::filesystem::path file = test::ownPath(name);
  std::filesystem::remove(file);
  return file;
}

/// Clear of the surface, then down on it and round and round there.
DeviceMm handAt(std::uint64_t tick) {
  const double t = 1e-3 * static_cast<double>(tick);
  return {9 * std::sin(3 * t), 7 * std::cos(2 * t), tick < 40 ? 8.0 : 1.5 * std::cos(5 * t) - 2.5};
}

HapticOptions fullForces() {
  HapticOptions options;
  options.force.forces_on = true;
  options.force.strength = 1;
  options.force.rise_s = 0.05;
  return options;
}

/// A device whose readings a script makes; it can get stuck until the watchdog has cut the force.
class Troubled : public Device {
 public:
  using Script = std::function<void(std::uint64_t tick, DeviceReading& reading)>;
  explicit Troubled(Script script) : script_(std::move(script)) {
    info_.id = info_.name = "troubled";
    info_.max_force_n = 5;
  }
  const DeviceInfo& info() const noexcept override { return info_; }
  void open() override {}
  void close() noexcept override {}
  void send(DeviceN, std::int64_t) RELIEVO_REALTIME override {}
  DeviceReading read(std::int64_t now_ns) RELIEVO_REALTIME override {
    DeviceReading reading{handAt(tick_), 0, now_ns, DeviceFault::none};
    script_(tick_, reading);
    if (stick_at == tick_) {
      const std::int64_t give_up_ns = monotonicNs() + 60'000'000'000;
      while (!cut_.load() && monotonicNs() < give_up_ns) sleepUntil(monotonicNs() + 1'000'000);
    }
    ++tick_;
    return reading;
  }
  void cutForce() noexcept override { cut_.store(true); }
  bool wasCut() const { return cut_.load(); }

  std::uint64_t stick_at = std::numeric_limits<std::uint64_t>::max();

 private:
  DeviceInfo info_;
  Script script_;
  std::uint64_t tick_ = 0;
  std::atomic<bool> cut_{false};
};

/// `relievo record` with a device of that script, as long as it wants or until it is stopped.
class Interruption : public ::testing::Test {
 protected:
  void record(const Troubled::Script& script, std::uint64_t ticks, std::uint64_t stop_at,
              std::uint64_t stick_at = std::numeric_limits<std::uint64_t>::max()) {
    auto device = std::make_unique<Troubled>(script);
    device->stick_at = stick_at;
    HapticLoop loop(std::move(device), {.fifo_priority = 0});
    // A computer that is busy makes the loop slow, which bounds the stiffness (E306).
    options_ = withinDevice(fullForces(), loop.device());
    loop.spaces().write(*space_);
    loop.options().write(fullForces());
    file_ = temporary("interrupted.csv");
    const auto log = openLog(file_, "relievo log", space_.get(), LogKind::recording);
    LoopRecording recording(*log, ticks);
    loop.start();
    {
      SampleDrain drain(loop.samples(),
                        {[&](std::span<const HapticSample> batch) { recording.take(batch); }});
      while (!recording.done()) {
        loop.latest().update();
        if (loop.latest().front().tick >= stop_at) break;
        sleepUntil(monotonicNs() + 1'000'000);
      }
      loop.stop();
    }
    loop.stats().update();
    log->close(loopLines(loop.stats().front()));
    EXPECT_EQ(recording.error(), "");
    EXPECT_EQ(recording.gaps(), 0);
    fault_ = recording.fault();
  }
  void expectTheSame() {
    const LogTable log = readLog(file_);
    double largest = 0;
    for (const TouchRow& row : log.rows) largest = std::max(largest, std::abs(row.force.z));
    EXPECT_GT(largest, 0.1) << "the hand felt something";
    const ReplayResult result =
        replay(*space_, options_, ForceChain::whole, log, [](const HapticSample&, double) {});
    EXPECT_EQ(result.ticks, log.rows.size());
    EXPECT_EQ(result.different, 0U) << (result.first ? result.first->column : "") << " in tick "
                                    << (result.first ? result.first->tick : 0);
  }
  static void nothing(std::uint64_t, DeviceReading&) {}

  std::unique_ptr<HapticSpace> space_ = test::spaceOf(
      80, [](double x, double y) { return std::sin(0.3 * x) * std::cos(0.2 * y); }, 4, {},
      SurfaceKind::crease_aware);
  HapticOptions options_;  ///< As the loop keeps them.
  std::filesystem::path file_;
  DeviceFault fault_ = DeviceFault::none;
};

TEST_F(Interruption, LeavingInContact) {
  record(nothing, 100'000, 400);
  expectTheSame();
}

TEST_F(Interruption, AFaultInContactThatStays) {
  record(
      [](std::uint64_t tick, DeviceReading& reading) {
        if (tick >= 300) reading.fault = DeviceFault::timeout;
      },
      450, 100'000);
  EXPECT_EQ(fault_, DeviceFault::timeout);
  expectTheSame();
}

TEST_F(Interruption, UnpluggedInContactAndBack) {
  record(
      [](std::uint64_t tick, DeviceReading& reading) {
        if (tick >= 300 && tick < 360)
          reading = {{}, 0, reading.time_ns, DeviceFault::disconnected};
        if (tick >= 360 && tick < 380) reading.fault = DeviceFault::not_ready;
      },
      450, 100'000);
  EXPECT_EQ(fault_, DeviceFault::not_ready) << "zero until forces are switched off and on";
  expectTheSame();
}

TEST_F(Interruption, AHandThatIsNoPlace) {
  record(
      [](std::uint64_t tick, DeviceReading& reading) {
        if (tick == 300) reading.position.y = std::nan("");
      },
      450, 100'000);
  EXPECT_EQ(fault_, DeviceFault::not_finite);
  expectTheSame();
}

TEST_F(Interruption, ACutByTheWatchdogAndTheResumingAfterIt) {
  record(nothing, 450, 100'000, 300);
  const LogTable log = readLog(file_);
  EXPECT_NE(log.header.find(", watchdog cuts "), std::string::npos) << log.header;
  EXPECT_EQ(log.header.find(", watchdog cuts 0,"), std::string::npos) << log.header;
  expectTheSame();
}

TEST_F(Interruption, AFaultAndThenLeaving) {
  record(
      [](std::uint64_t tick, DeviceReading& reading) {
        if (tick >= 300) reading.fault = DeviceFault::protocol;
      },
      100'000, 350);
  expectTheSame();
}

TEST_F(Interruption, AGapOfDroppedSamplesIsSaid) {
  record(nothing, 300, 100'000);
  LogTable log = readLog(file_);
  log.rows.erase(log.rows.begin() + 100);
  EXPECT_THROW(
      replay(*space_, fullForces(), ForceChain::whole, log, [](const HapticSample&, double) {}),
      FileError);
}

/// A loop without a thread and without waiting, whose readings, cuts, pauses and end are drawn.
class Drawn {
 public:
  explicit Drawn(unsigned seed) : random_(seed) {}

  std::vector<HapticSample> samples(const HapticSpace& space, const HapticOptions& asked,
                                    std::uint64_t least = 60) {
    std::vector<HapticSample> all;
    HapticCore core;
    DeviceFault fault = DeviceFault::none;
    bool silent = false;
    const std::uint64_t ticks = least + draw(once(10) ? 4000 : 400);
    std::int64_t now_ns = 3'000'000'000 + static_cast<std::int64_t>(draw(1000));
    for (std::uint64_t tick = 0; tick < ticks; ++tick) {
      now_ns += 1'000'000 + (once(300) ? static_cast<std::int64_t>(draw(50'000'000)) : 0);
      if (once(200)) core.resume();
      if (once(fault == DeviceFault::none ? 200 : 30)) fault = drawFault();
      if (once(400)) held_ = !held_;
      if (once(300)) silent = !silent;
      DeviceReading reading{handAt(tick), held_ ? 4U : 0U, now_ns, fault};
      if (once(50)) reading.time_ns -= static_cast<std::int64_t>(draw(30'000'000));
      if (once(200)) reading.position.x = std::numeric_limits<double>::infinity();
      HapticOptions options = asTheLoopHad(asked, silent ? kSilentBit : 0);
      if (tick + 1 == ticks && once(2)) options = asTheLoopLeaves(options);
      all.push_back(core.tick(space, options, reading, now_ns));
    }
    return all;
  }

 private:
  std::uint64_t draw(std::uint64_t below) {
    return std::uniform_int_distribution<std::uint64_t>(0, below - 1)(random_);
  }
  bool once(std::uint64_t in) { return draw(in) == 0; }
  DeviceFault drawFault() { return static_cast<DeviceFault>(draw(7)); }
  static HapticOptions asTheLoopLeaves(HapticOptions options) {
    options.force.forces_on = false;
    options.id |= kLeavingBit;
    return options;
  }

  std::mt19937_64 random_;
  bool held_ = false;
};

TEST_F(Interruption, WhatIsOnTheDiskOfARecordingThatWasNeverClosedIsTheSame) {
  const HapticOptions options = fullForces();
  int with_fault = 0;
  for (unsigned seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    // A log writes out some hundred rows at a time.
    const bool as_hdf5 = seed % 5 == 0;
    const std::vector<HapticSample> samples =
        Drawn(seed).samples(*space_, options, as_hdf5 ? 4200 : 400);
    const char* const ending = as_hdf5 ? ".h5" : ".csv";
    const std::filesystem::path file = temporary(std::string("open") + ending);
    const std::filesystem::path left = temporary(std::string("left") + ending);
    const auto log = openLog(file, "relievo log", space_.get(), LogKind::recording);
    LoopRecording recording(*log, 100'000);
    recording.take(samples);
    std::filesystem::copy_file(file, left, std::filesystem::copy_options::overwrite_existing);
    // Killed in the middle of a row.
    if (left.extension() == ".csv") {
      std::filesystem::resize_file(left, std::filesystem::file_size(left) - 7 * seed);
    }
    const LogTable table = readLog(left);
    ASSERT_GT(table.rows.size(), 100U);
    ASSERT_LE(table.rows.size(), samples.size());
    const ReplayResult result =
        replay(*space_, options, ForceChain::whole, table, [](const HapticSample&, double) {});
    EXPECT_EQ(result.different, 0U) << result.first->column << " in tick " << result.first->tick;
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
      with_fault += samples[i].fault != DeviceFault::none ? 1 : 0;
    }
  }
  EXPECT_GT(with_fault, 100);
}

TEST_F(Interruption, ALogOnAFullDiskCountsItsRowsAndNotTheLinesBetweenThem) {
  HapticSample sample;
  for (const char* const name : {"full.csv", "full.h5"}) {
    const std::filesystem::path file = temporary(name);
    const auto log = openLog(file, "relievo log", nullptr, LogKind::recording);
    std::uint64_t told = 0;
    {
      const test::SizeLimit disk(300'000);
      try {
        for (; sample.tick < 100'000; ++sample.tick) {
          if (sample.tick % 3 == 0) log->keep(changeLine(nullptr, sample));
          sample.hip.x = std::sin(0.1 * static_cast<double>(sample.tick));
          log->write(sample, 1e-3 * static_cast<double>(sample.tick), {});
        }
        FAIL() << "the disk is full";
      } catch (const WriteError&) {
        told = log->rows();
      }
    }
    const LogTable table = readLog(file);
    EXPECT_EQ(table.rows.size(), told) << name;
    EXPECT_GE(loopChanges(table.footer).size(), table.rows.size() / 3) << name;
    sample = {};
  }
}

TEST_F(Interruption, TwoHundredRandomRecordingsWithRandomInterruptionsAllVerify) {
  const HapticOptions options = fullForces();
  int faults = 0, resumed = 0, left = 0, held = 0, silent = 0;
  for (unsigned seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const std::vector<HapticSample> samples = Drawn(seed).samples(*space_, options);
    const std::filesystem::path file = temporary(seed % 10 == 0 ? "drawn.h5" : "drawn.csv");
    {
      const auto log = openLog(file, "relievo log", space_.get(), LogKind::recording);
      LoopRecording recording(*log, 100'000);
      recording.take(samples);
      log->close("loop ticks 1\n");
    }
    const LogTable log = readLog(file);
    ASSERT_EQ(log.rows.size(), samples.size());
    const ReplayResult result =
        replay(*space_, options, ForceChain::whole, log, [](const HapticSample&, double) {});
    ASSERT_EQ(result.different, 0U) << result.first->column << " in tick " << result.first->tick;
    for (const HapticSample& sample : samples) {
      faults += sample.fault != DeviceFault::none ? 1 : 0;
      resumed += sample.resumed ? 1 : 0;
      held += sample.stopped == StopReason::held ? 1 : 0;
      silent += sample.stopped == StopReason::window_silent ? 1 : 0;
    }
    left += (samples.back().options_id & kLeavingBit) != 0 ? 1 : 0;
  }
  EXPECT_GT(faults, 1000);
  EXPECT_GT(resumed, 100);
  EXPECT_GT(left, 50);
  EXPECT_GT(held, 100);
  EXPECT_GT(silent, 100);
}

}  // namespace
}  // namespace relievo
