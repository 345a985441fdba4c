// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include "haptics/loop/haptic_core.h"
#include "tests/haptics/haptic_fixture.h"
#include "tests/haptics/proxy/measure.h"

namespace relievo::test {

inline double hollows(double x, double y) {
  return 0.15 * std::sin(1.2 * x) * std::cos(1.1 * y);
}

/// Hollows 5.2 mm apart along x of which every other one is soft.
inline std::unique_ptr<HapticSpace> hollowsOfDifferingFirmness(SurfaceKind kind) {
  constexpr double kSideMm = 80;
  std::vector<float> firmness(kWindowCount);
  for (std::size_t i = 0; i < kWindowCount; ++i) {
    const double x = 0.4 * (static_cast<double>(i % kWindowSamples) + 0.5);
    firmness[i] = std::sin(0.6 * x) < 0 ? 1.0F : 0.0F;
  }
  auto space = std::make_unique<HapticSpace>();
  fill(*space, windowOf(kSideMm, hollows), {}, kind, {}, firmness);
  return space;
}

/// Work of the force, without the passivity stage, on a hand without friction that goes round and
/// round: deep into a soft hollow, over to a firm one, so deep that the proxy slips, and out there.
inline Work workOverHollows(SurfaceKind kind, double depth_mm) {
  const auto space = hollowsOfDifferingFirmness(kind);
  HapticOptions options;
  options.stiffness_by_detail = false;
  options.fields.softest_part = 0.5;
  constexpr int kRounds = 20, kSideTicks = 500;
  constexpr double kSoftX = -4.65, kFirmX = 0.57, kAboveMm = 1;
  const std::array<DeviceMm, 4> corners{{{kSoftX, 0.1, kAboveMm},
                                         {kSoftX, 0.1, -depth_mm},
                                         {kFirmX, 0.1, -depth_mm},
                                         {kFirmX, 0.1, kAboveMm}}};
  HapticCore core(ForceChain::bare);
  HapticSample before;
  Work work;
  for (int i = 0; i <= 4 * kRounds * kSideTicks; ++i) {
    const auto side = static_cast<std::size_t>(i / kSideTicks) % 4;
    const double part = static_cast<double>(i % kSideTicks) / kSideTicks;
    DeviceReading reading;
    reading.time_ns = i * 1'000'000LL;
    reading.position = corners[side] + part * (corners[(side + 1) % 4] - corners[side]);
    const HapticSample sample = core.tick(*space, options, reading, reading.time_ns);
    if (i > 0) {
      const DeviceN mean = 0.5 * (sample.force + before.force);
      const DeviceMm way = sample.hip - before.hip;
      const double mj = mean.x * way.x + mean.y * way.y + mean.z * way.z;
      work.net_mj += mj;
      work.gross_mj += std::abs(mj);
    }
    before = sample;
  }
  return work;
}

}  // namespace relievo::test
