// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/loop/stable_stiffness.h"

#include <algorithm>
#include <array>

namespace relievo {

namespace {
constexpr int kMostDelay = 2;

/// The map by rate: the least over scenes and grips in steps of 0.1 N/mm, 0.02 at 100 a second, for
/// 0, 1 and 2 ticks of delay. `stability_map --rates` measures it (docs/dev/stability.md). Less
/// than the last step was measured at 100 a second with two ticks of delay.
struct Row {
  double rate_hz;
  std::array<double, kMostDelay + 1> alone, with_stage;
};
constexpr std::array<Row, 6> kMap{{
    {100, {0.08, 0.06, 0.06}, {0.08, 0.04, 0.01}},
    {300, {0.1, 0.1, 0.1}, {0.2, 0.1, 0.1}},
    {400, {0.2, 0.2, 0.2}, {0.3, 0.3, 0.2}},
    {600, {0.4, 0.3, 0.3}, {0.6, 0.5, 0.5}},
    {800, {0.6, 0.5, 0.5}, {1.0, 0.9, 0.8}},
    {1000, {0.8, 0.7, 0.6}, {1.4, 1.3, 1.1}},
}};

/// The counts that the map was made with, mm; finer ones change nothing.
constexpr double kMapStepMm = 0.0635;

/// Below the slowest row the stiffness falls with the rate; above the fastest it stays.
template <class Column>
double inMap(const DeviceTiming& timing, const Column& column) RELIEVO_REALTIME {
  const auto delay = static_cast<std::size_t>(std::clamp(timing.delay_ticks, 0, kMostDelay));
  const double rate = std::max(0.0, timing.rate_hz);
  if (rate <= kMap.front().rate_hz) {
    return rate / kMap.front().rate_hz * column(kMap.front())[delay];
  }
  for (std::size_t i = 1; i < kMap.size(); ++i) {
    const Row &slow = kMap[i - 1], &fast = kMap[i];
    if (rate > fast.rate_hz) continue;
    const double part = (rate - slow.rate_hz) / (fast.rate_hz - slow.rate_hz);
    return column(slow)[delay] + part * (column(fast)[delay] - column(slow)[delay]);
  }
  return column(kMap.back())[delay];
}

/// What friction has to hold of a count is the spring's step, K times the count (Abbott and Okamura
/// 2005, eq. 14): beyond the counts of the map the stiffness falls as they grow.
double ofCounts(const DeviceTiming& timing) RELIEVO_REALTIME {
  return timing.position_step_mm > kMapStepMm ? kMapStepMm / timing.position_step_mm : 1;
}
}  // namespace

double stableStiffness(const DeviceTiming& timing) RELIEVO_REALTIME {
  const double k = inMap(
      timing, [](const Row& row) -> const auto& { return row.with_stage; });
  return ofCounts(timing) * k;
}

double stableStiffnessAlone(const DeviceTiming& timing) RELIEVO_REALTIME {
  const double k = inMap(
      timing, [](const Row& row) -> const auto& { return row.alone; });
  return ofCounts(timing) * k;
}

DetailStiffness detailStiffness(const DeviceTiming& timing) RELIEVO_REALTIME {
  constexpr std::size_t kCoarse = 2;  // Details without texture to speak of.
  const double coarse = kStabilityMargin * stableStiffness(timing);
  const double fine = std::min(coarse, stableStiffnessAlone(timing));
  DetailStiffness all = kDetailStiffness;
  for (std::size_t i = 0; i < all.size(); ++i)
    all[i] = std::min(all[i], i < kCoarse ? coarse : fine);
  return all;
}

DeviceTiming timingOf(const DeviceInfo& device) RELIEVO_REALTIME {
  return {device.rate_hz, device.force_delay_ticks, device.position_step_mm};
}

double stiffnessForDetail(int detail, const DeviceInfo& device) RELIEVO_REALTIME {
  return stiffnessForDetail(detail, detailStiffness(timingOf(device)));
}

}  // namespace relievo
