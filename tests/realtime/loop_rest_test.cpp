// SPDX-License-Identifier: BSD-3-Clause
// A loop that rests: fewer ticks, and only where nothing can be pushed. Computers are noisy, so
// that only what no noise can change is asserted: a sleep never ends too early.
#include <gtest/gtest.h>

#include <optional>
#include <thread>

#include "haptics/device/mouse_device.h"
#include "haptics/device/virtual_hand.h"
#include "haptics/loop/haptic_loop.h"
#include "tests/haptics/haptic_fixture.h"

namespace relievo {
namespace {

constexpr std::int64_t kUsualNs = 1'000'000, kRestNs = HapticLoop::kRestPeriodNs;

class LoopAtRest : public ::testing::Test {
 protected:
  void start(std::unique_ptr<Device> device) {
    loop_ = std::make_unique<HapticLoop>(std::move(device));
    loop_->spaces().write(*test::spaceOf(
        80, [](double, double) { return 0.0; }, 1));
    loop_->start();
  }

  HapticSample next() {
    HapticSample sample;
    while (!loop_->samples().pop(sample)) std::this_thread::yield();
    return sample;
  }

  void passWhatWasBefore() {
    for (HapticSample sample; loop_->samples().pop(sample);) {
    }
    for (int i = 0; i < 3; ++i) next();  // A tick that was at work, and one that it waited for.
  }

  /// How long so many ticks took, from one to the last of them.
  std::int64_t timeOf(int ticks) {
    const std::int64_t first = next().time_ns;
    std::int64_t last = first;
    for (int i = 0; i < ticks; ++i) last = next().time_ns;
    return last - first;
  }

  /// Whether two ticks come as close as those of a loop at work; asked for as long as a slow
  /// computer may need.
  bool isAtWork() {
    constexpr int kTicks = 5000;
    std::int64_t before = next().time_ns;
    for (int i = 0; i < kTicks; ++i) {
      const std::int64_t now = next().time_ns;
      const bool close = now - before < 2 * kUsualNs;
      const bool next_too = close && next().time_ns - now < 2 * kUsualNs;
      if (next_too) return true;
      before = now;
    }
    return false;
  }

  std::unique_ptr<HapticLoop> loop_;
};

TEST_F(LoopAtRest, OfAMouseTicksAQuarterAsOftenAndAtWorkAgainAsBefore) {
  start(std::make_unique<MouseDevice>());
  EXPECT_TRUE(isAtWork());
  loop_->rest(true);
  constexpr int kTicks = 25;
  passWhatWasBefore();
  // The first of them may have been late, though by less than a period.
  EXPECT_GE(timeOf(kTicks), (kTicks - 1) * kRestNs);
  loop_->stats().update();
  EXPECT_TRUE(loop_->stats().front().at_rest);
  loop_->rest(false);
  EXPECT_TRUE(isAtWork());
  loop_->stats().update();
  EXPECT_FALSE(loop_->stats().front().at_rest);
}

TEST_F(LoopAtRest, ADeviceThatPushesIsNeverLeftAloneForLonger) {
  start(std::make_unique<VirtualHand>());
  loop_->rest(true);
  passWhatWasBefore();
  EXPECT_TRUE(isAtWork());
  loop_->stats().update();
  EXPECT_FALSE(loop_->stats().front().at_rest);
}

TEST_F(LoopAtRest, NoneIsThereWhileSomebodyListens) {
  start(std::make_unique<MouseDevice>());
  loop_->listen(true);
  loop_->rest(true);
  passWhatWasBefore();
  EXPECT_TRUE(isAtWork());
}

}  // namespace
}  // namespace relievo
