// SPDX-License-Identifier: BSD-3-Clause
// E306: a loop or a device that is too slow for its surface.
#include "haptics/loop/rate_watch.h"

#include <gmock/gmock.h>

#include "haptics/record/events.h"
#include "tests/haptics/stability.h"

namespace relievo {
namespace {

using testing::HasSubstr;

constexpr std::int64_t kMs = 1'000'000;

/// @return the rate that is told after so long
double after(RateWatch& watch, std::int64_t& now_ns, double seconds, std::int64_t period_ns,
             int ticks_per_reading = 1) {
  std::int64_t reading_ns = now_ns;
  const auto ticks = static_cast<int>(1e9 * seconds / static_cast<double>(period_ns));
  for (int i = 0; i < ticks; ++i) {
    now_ns += period_ns;
    if (i % ticks_per_reading == 0) reading_ns = now_ns;
    watch.tick(now_ns, reading_ns);
  }
  return watch.slowHz();
}

TEST(RateWatch, TheSlowerOfLoopAndDeviceCounts) {
  RateWatch watch;
  std::int64_t now_ns = 0;
  EXPECT_EQ(after(watch, now_ns, 1, kMs), 0);
  EXPECT_EQ(after(watch, now_ns, 1, kMs * 10 / 9), 0) << "900 a second";
  EXPECT_NEAR(after(watch, now_ns, 1, 2 * kMs), 500, 5) << "the loop";
  watch.reset();
  EXPECT_NEAR(after(watch, now_ns, 1, kMs, 4), 250, 3) << "the device";
}

TEST(RateWatch, ItIsOverOnceItWasGoodForTwoSeconds) {
  RateWatch watch;
  std::int64_t now_ns = 0;
  after(watch, now_ns, 1, 2 * kMs);
  EXPECT_GT(after(watch, now_ns, 1.5, kMs), 0);
  EXPECT_EQ(after(watch, now_ns, 1, kMs), 0);
}

/// One pause starts the force from zero; many are a slow loop.
TEST(RateWatch, APauseIsNotARateButManyAre) {
  RateWatch watch;
  std::int64_t now_ns = 0;
  after(watch, now_ns, 1, kMs);
  now_ns += 6000 * kMs;
  EXPECT_EQ(after(watch, now_ns, 1, kMs), 0);
  for (int i = 0; i < 60; ++i) {
    now_ns += 100 * kMs;
    after(watch, now_ns, 0.01, kMs);
  }
  EXPECT_GT(watch.slowHz(), 0);
  EXPECT_LT(watch.slowHz(), 500);
}

/// A hand that rests on the flat in the lightest grip, which is the hardest to keep stable.
class SlowLoopTest : public ::testing::Test {
 protected:
  static VirtualHandOptions hand() {
    VirtualHandOptions options = test::likeTheFalcon();
    options.hand = kHandPresets[0];
    return options;
  }
  static HapticOptions options() {
    HapticOptions options;
    options.force.strength = 1;
    options.force.oscillation.on = false;
    return options;
  }
  static constexpr DeviceMm kClear{0, 0, 3}, kPressed{0, 0, -40};  // 2 N of the light grip.

  /// @param lands  lifts off first: dry friction can hold what would swing until it is struck
  /// @return the largest swing above 20 Hz of the last half second
  double rest(double seconds, std::int64_t period_ns, bool lands = false) {
    loop_.setPeriod(period_ns);
    const auto ticks = static_cast<int>(1e9 * seconds / static_cast<double>(period_ns));
    test::Swing swing(1e-9 * static_cast<double>(period_ns));
    for (int i = 0; i < ticks; ++i) {
      const bool lifts = lands && i < static_cast<int>(0.5e9 / static_cast<double>(period_ns));
      const HapticSample sample = loop_.tick(lifts ? kClear : kPressed);
      if (last_) {
        const std::string event = eventBetween(*last_, sample);
        if (event.find("E306") != std::string::npos) ++told_;
        // What the stiffness alone does to the force; a hand slips by a count now and then.
        const double changed = sample.firm_stiffness_n_per_mm - last_->firm_stiffness_n_per_mm;
        const double depth_mm = norm(sample.proxy - sample.hip);
        largest_step_n_ = std::max(largest_step_n_, std::abs(changed) * depth_mm);
      }
      last_ = sample;
      if (i == ticks - static_cast<int>(0.5e9 / static_cast<double>(period_ns))) swing.restart();
      swing.add(sample.force.z);
    }
    return swing.peakToPeak();
  }

  std::unique_ptr<HapticSpace> space_ = test::spaceOf(80, [](double, double) { return 0.0; });
  test::ClosedLoop loop_{*space_, hand(), options()};
  std::optional<HapticSample> last_;
  int told_ = 0;
  double largest_step_n_ = 0;
};

TEST_F(SlowLoopTest, TheBoundOfTheRateHoldsIsToldOnceAndComesBackSlowly) {
  loop_.switchOn(kClear);
  rest(1, kMs);
  ASSERT_EQ(last_->slow.rate_hz, 0);
  EXPECT_DOUBLE_EQ(last_->firm_stiffness_n_per_mm, 0.8);
  const double before_n = norm(last_->force);
  ASSERT_GT(before_n, 1);

  constexpr std::int64_t kSlow = 2'500'000;
  const double swing_n = rest(4, kSlow, true);
  EXPECT_NEAR(last_->slow.rate_hz, 400, 4);
  EXPECT_DOUBLE_EQ(last_->slow.asked_n_per_mm, 0.8);
  const double bound = kStabilityMargin * stableStiffness({400, 2, 0.048});
  EXPECT_NEAR(last_->slow.held_n_per_mm, bound, 0.01);
  EXPECT_NEAR(last_->firm_stiffness_n_per_mm, bound, 0.01);
  EXPECT_LT(swing_n, test::kStillN);
  EXPECT_EQ(told_, 1);

  largest_step_n_ = 0;
  rest(2.2, kMs);
  EXPECT_LT(last_->firm_stiffness_n_per_mm, 0.8) << "not at once";
  rest(4, kMs);
  EXPECT_EQ(last_->slow.rate_hz, 0);
  EXPECT_DOUBLE_EQ(last_->firm_stiffness_n_per_mm, 0.8);
  EXPECT_LE(largest_step_n_, 0.005) << "N in a tick";
  EXPECT_GT(largest_step_n_, 0);
  EXPECT_EQ(told_, 1);
}

TEST_F(SlowLoopTest, WithoutTheBoundTheSameHandSwings) {
  loop_.options().bound_by_rate = false;
  loop_.switchOn(kClear);
  rest(1, kMs);
  EXPECT_GT(rest(4, 2'500'000, true), 4 * test::kStillN);
}

TEST(SlowRate, ARecordingTellsWhenItBeganAndWhenItWasOver) {
  HapticSample before, now;
  now.tick = 1;
  now.slow = {412, 0.8, 0.45};
  EXPECT_THAT(eventBetween(before, now),
              HasSubstr("E306: update rate 412 per second; stiffness 450 instead of 800 N/m"));
  EXPECT_THAT(eventBetween(now, before), HasSubstr("no longer bound by the update rate"));
}

}  // namespace
}  // namespace relievo
