// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

#include "core/tiles/level_files.h"
#include "core/tiles/published/windows_ahead.h"
#include "haptics/loop/haptic_core.h"
#include "haptics/loop/scene_buffer.h"

namespace relievo::test {

// A hand rests on a map that comes from the web while the window goes over it: the map, its windows
// in the loop's buffer, and the hand on the bare chain.

inline constexpr double kWalkSpacingMm = 0.1;
inline constexpr GridSize kWalkSize{.cols = 3000, .rows = 3000};
inline constexpr double kWalkSideMm = 200 * kWalkSpacingMm;
/// As tests/haptics/loop/scene_change_test: what the blend of two surfaces may change in a tick.
inline constexpr double kMostWalkStepN = 0.005;
/// Ticks until the hand has come to rest.
inline constexpr long kRestsAfterTicks = 600;

/// Waves of 1.5 mm, and grooves of 0.2 mm that coarser levels do not have.
inline void writeWalkRelief(const std::filesystem::path& file) {
  LevelFiles files(file,
                   {.size = kWalkSize,
                    .spacing_mm = kWalkSpacingMm,
                    .first_x_mm = 0.5 * kWalkSpacingMm,
                    .first_y_mm = 0.5 * kWalkSpacingMm},
                   {.factor = 2});
  std::vector<float> heights(static_cast<std::size_t>(kWalkSize.cols));
  const std::vector<CellStatus> origins(heights.size(), CellStatus::measured);
  for (int row = 0; row < kWalkSize.rows; ++row) {
    for (int col = 0; col < kWalkSize.cols; ++col) {
      const double x = kWalkSpacingMm * col, y = kWalkSpacingMm * row;
      heights[static_cast<std::size_t>(col)] = static_cast<float>(
          1.5 * std::sin(0.35 * x) * std::cos(0.3 * y) + 0.2 * std::sin(7 * x) * std::sin(6 * y));
    }
    files.add(heights.data(), origins.data());
  }
  files.finish({});
}

/// Lays a window where the loop takes the next one. [one thread]
inline void layWindow(SceneBuffer<HapticSpace>& scenes, const RegionWindow& window,
                      std::uint64_t scene_id) {
  HapticSpace& space = scenes.back();
  fill(space, window, {window.levels - window.region.level.value, window.levels},
       SurfaceKind::crease_aware);
  space.scene_id = scene_id;
  scenes.publish();
}

/// The hand goes down on the middle of the window and stays; every call is one tick of 1 ms.
class WalkingHand {
 public:
  explicit WalkingHand(SceneBuffer<HapticSpace>& scenes)
      : scenes_(scenes), core_(ForceChain::bare) {
    options_.stiffness_by_detail = false;
    options_.force.stiffness_n_per_mm = 0.5;
  }

  /// Of it nothing may allocate.
  HapticSample tick() {
    DeviceReading reading;
    const double down = std::min(1.0, static_cast<double>(ticks_) / 300);
    reading.position = {0, 0, 35 - 38 * down};
    reading.time_ns = ticks_ * 1'000'000;
    if (!core_.changing()) scenes_.update();
    const HapticSample sample =
        core_.tick(scenes_.front(), scenes_.previous(), options_, reading, reading.time_ns);
    if (ticks_ > kRestsAfterTicks) {
      largest_step_n_ = std::max(largest_step_n_, norm(sample.force - last_));
    }
    last_ = sample.force;
    ++ticks_;
    return sample;
  }

  bool changing() const { return core_.changing(); }
  long ticks() const { return ticks_; }
  double largestStepN() const { return largest_step_n_; }  ///< Of a hand at rest.

 private:
  SceneBuffer<HapticSpace>& scenes_;
  HapticCore core_;
  HapticOptions options_;
  DeviceN last_{};
  long ticks_ = 0;
  double largest_step_n_ = 0;
};

}  // namespace relievo::test
