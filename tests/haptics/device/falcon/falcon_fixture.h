// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>
#include <pthread.h>
#include <sched.h>

#include <atomic>
#include <functional>
#include <memory>
#include <semaphore>
#include <string>

#include "core/base/error.h"
#include "haptics/device/falcon/falcon_device.h"
#include "tests/emulator/in_process.h"
#include "tests/emulator/made_image.h"

namespace relievo::falcon::test {

/// The driver and an emulated Falcon on a made-up clock: the driver's thread stops at every
/// millisecond until the test lets it go on. Nothing depends on how fast anything runs.
class FalconTest : public ::testing::Test {
 protected:
  explicit FalconTest(emulator::EmulatorOptions options = {})
      : emulated_(std::make_shared<emulator::SharedFalcon>(options)) {
    auto bus = std::make_unique<emulator::InProcessBus>(emulated_, clock_);
    bus_ = bus.get();
    FalconSettings settings;
    settings.counts_per_n_mm = kNominalCountsPerNmm;  // What the emulated motors have.
    device_ = std::make_unique<FalconDevice>(
        std::move(bus),
        [this] {
          ++firmware_asked_;
          sched_param parameters{};
          pthread_getschedparam(pthread_self(), &firmware_policy_, &parameters);
          if (firmware_.empty()) throw FileError("No firmware. Places searched: none.");
          return firmware_;
        },
        settings);
    clock_->every_ms = [this](std::int64_t) {
      if (free_) return;
      reached_.release();
      go_.acquire();
    };
  }
  ~FalconTest() override { finish(); }

  template <class Function>
  auto falcon(Function function) {
    return emulated_->with(function);
  }

  void begin() {
    device_->openWhenPlugged();
    reached_.acquire();
    begun_ = true;
  }
  void finish() {
    if (!begun_) return;
    begun_ = false;
    free_ = true;
    go_.release();
    device_->close();
  }
  /// Lets milliseconds pass, as a loop that asks for `force_` would.
  void step(int ms = 1) {
    for (int i = 0; i < ms; ++i) {
      if (loop_runs_) {
        reading_ = device_->exchange(force_, clock_->now());
        if (reading_.fault != DeviceFault::none) fault_ = reading_.fault;
      }
      go_.release();
      reached_.acquire();
    }
  }
  /// Presses and releases that a loop sees, as signed numbers of buttons from 1 on.
  std::vector<int> edges(int ms) {
    std::vector<int> seen;
    for (int i = 0; i < ms; ++i) {
      const std::uint32_t before = reading_.buttons;
      step();
      for (int button = 0; button < 4; ++button) {
        const bool was = (before >> button & 1U) != 0, is = (reading_.buttons >> button & 1U) != 0;
        if (was != is) seen.push_back(is ? button + 1 : -(button + 1));
      }
    }
    return seen;
  }
  /// @return false: it did not become so
  bool stepUntil(const std::function<bool()>& holds, int most_ms) {
    for (int i = 0; i < most_ms; ++i) {
      if (holds()) return true;
      step();
    }
    return holds();
  }
  bool becomes(LinkState state, int most_ms) {
    return stepUntil([&] { return device_->status().state == state; }, most_ms);
  }
  void hold(double x, double y, double z) {
    falcon([&](auto& f) { f.body.carry({x, y, z}); });
  }
  /// Out and in, as E308 asks for first; then out once more, as it asks for when they are homed.
  bool home() {
    hold(0, 0, 172);
    step(20);
    hold(0, 0, 90);
    if (!becomes(LinkState::pull_out, 100)) return false;
    hold(0, 0, 172);
    return becomes(LinkState::ready, 100);
  }
  emulator::SeenCommand lastCommand() {
    return falcon([](auto& f) {
      return f.commands().empty() ? emulator::SeenCommand{} : f.commands().back();
    });
  }
  /// Of the motors on the hand, by the emulator's own geometry.
  DeviceN felt() {
    const emulator::Triple f = falcon([](auto& e) { return e.body.force(); });
    return {f[0], f[1], f[2]};
  }

  std::shared_ptr<emulator::SharedFalcon> emulated_;
  std::shared_ptr<emulator::TestClock> clock_ = std::make_shared<emulator::TestClock>();
  emulator::InProcessBus* bus_ = nullptr;  // The device's.
  std::unique_ptr<FalconDevice> device_;
  std::vector<std::uint8_t> firmware_ = relievo::test::madeImage();
  int firmware_policy_ = -1;  // Of the thread that read it.
  int firmware_asked_ = 0;    // How often the driver has looked for it.

  DeviceN force_;
  DeviceReading reading_;
  DeviceFault fault_ = DeviceFault::none;  // The last one; stays.
  bool loop_runs_ = true;

 private:
  std::binary_semaphore reached_{0}, go_{0};
  std::atomic<bool> free_{false};
  bool begun_ = false;
};

/// One that another program has already started and homed.
class RunningFalconTest : public FalconTest {
 protected:
  RunningFalconTest() : FalconTest({.firmware_loaded = true, .homed = true}) {}
  /// Ready, in contact: 2 N are felt.
  void beginTouching() {
    hold(10, -5, 130);
    begin();
    ASSERT_TRUE(becomes(LinkState::ready, 100));
    force_ = {0, 0, 2};
    ASSERT_TRUE(stepUntil([this] { return norm(felt()) > 1.9; }, 300));
    fault_ = DeviceFault::none;
  }
};

}  // namespace relievo::falcon::test
