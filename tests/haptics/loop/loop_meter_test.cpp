// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/loop/loop_meter.h"

#include <gtest/gtest.h>

#include <numeric>

namespace relievo {
namespace {

constexpr std::int64_t kPeriodNs = 1'000'000, kDeadlineNs = 5'000'000'000;

TEST(LoopMeter, ATickIsLateFromMoreThanHalfAPeriodOn) {
  for (const std::int64_t period_ns : {kPeriodNs, 2 * kPeriodNs}) {
    LoopMeter meter;
    meter.begin(kDeadlineNs - period_ns);
    EXPECT_FALSE(meter.wake(kDeadlineNs, kDeadlineNs, period_ns));
    EXPECT_FALSE(meter.wake(kDeadlineNs, kDeadlineNs + period_ns / 2, period_ns));
    EXPECT_EQ(meter.stats().late_ticks, 0U);
    EXPECT_TRUE(meter.wake(kDeadlineNs, kDeadlineNs + period_ns / 2 + 1, period_ns));
    EXPECT_EQ(meter.stats().late_ticks, 1U);
    EXPECT_EQ(meter.stats().ticks, 3U);
  }
}

TEST(LoopMeter, CountsEachDelayAndEachWorkTimeInItsBin) {
  LoopMeter meter;
  std::int64_t deadline_ns = kDeadlineNs;
  const auto wake = [&](std::int64_t delay_ns) {
    meter.wake(deadline_ns, deadline_ns + delay_ns, kPeriodNs);
    deadline_ns += 1'000 * kPeriodNs;
  };
  for (std::size_t bin = 0; bin < LoopStats::kDelayEdgesNs.size(); ++bin) {
    wake(LoopStats::kDelayEdgesNs[bin]);      // The edge itself is in the bin below it.
    wake(LoopStats::kDelayEdgesNs[bin] + 1);  // What is beyond it in the next.
    meter.computed(LoopStats::kWorkEdgesNs[bin]);
    meter.computed(LoopStats::kWorkEdgesNs[bin] + 1);
  }
  const LoopStats& stats = meter.stats();
  EXPECT_EQ(stats.delays.front(), 1U);
  EXPECT_EQ(stats.delays.back(), 1U);
  EXPECT_EQ(stats.work.front(), 1U);
  for (std::size_t bin = 1; bin + 1 < stats.delays.size(); ++bin) {
    EXPECT_EQ(stats.delays[bin], 2U) << bin;
    EXPECT_EQ(stats.work[bin], 2U) << bin;
  }
  EXPECT_EQ(std::accumulate(stats.delays.begin(), stats.delays.end(), std::uint64_t{0}),
            stats.ticks);
  EXPECT_DOUBLE_EQ(stats.worst_tick_us, 1e-3 * (LoopStats::kWorkEdgesNs.back() + 1));
}

TEST(LoopMeter, RateAndLongestPeriodAreThoseOfTheTicks) {
  LoopMeter meter;
  meter.begin(kDeadlineNs);
  std::int64_t now_ns = kDeadlineNs;
  for (int i = 0; i < 256; ++i) {
    now_ns += i == 100 ? 9 * kPeriodNs : 2 * kPeriodNs;
    meter.wake(now_ns, now_ns, 2 * kPeriodNs);
  }
  EXPECT_DOUBLE_EQ(meter.stats().worst_period_ms, 9);
  EXPECT_NEAR(meter.stats().rate_hz, 256 / (0.002 * 255 + 0.009), 1e-9);
}

TEST(LoopMeter, RestIsNoMeasureOfTheRateNorOfTheLongestPeriod) {
  LoopMeter meter;
  meter.begin(kDeadlineNs);
  std::int64_t now_ns = kDeadlineNs;
  const auto ticks = [&](int count, std::int64_t period_ns, bool at_rest) {
    for (int i = 0; i < count; ++i) {
      now_ns += period_ns;
      EXPECT_FALSE(meter.wake(now_ns, now_ns, period_ns, at_rest));
      EXPECT_EQ(meter.stats().at_rest, at_rest);
    }
  };
  ticks(300, kPeriodNs, false);
  ticks(300, 4 * kPeriodNs, true);
  EXPECT_DOUBLE_EQ(meter.stats().rate_hz, 1000) << "that of before";
  EXPECT_DOUBLE_EQ(meter.stats().worst_period_ms, 1);
  ticks(256, 2 * kPeriodNs, false);
  EXPECT_DOUBLE_EQ(meter.stats().rate_hz, 500) << "nothing of the rest is in it";
  EXPECT_DOUBLE_EQ(meter.stats().worst_period_ms, 2);
  EXPECT_EQ(meter.stats().ticks, 856U);
}

}  // namespace
}  // namespace relievo
