// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <type_traits>

#include "haptics/loop/haptic_core.h"
#include "haptics/rt/spsc_ring.h"

namespace relievo {

/// All that the next tick starts from: with it, and with every hand, option and surface from then
/// on, a build of the same arithmetic repeats a running loop to the last bit.
struct CoreSnapshot {
  std::uint64_t tick = 0;  ///< The one that comes next.
  HapticCore core;
  std::uint64_t scene_id = 0, previous_scene_id = 0;  ///< HapticSpace::scene_id.
  bool gradual = false;  ///< Surfaces change gradually: the device can push back.
};
static_assert(std::is_trivially_copyable_v<CoreSnapshot>);

using SnapshotRing = SpscRing<CoreSnapshot, 4>;

/// Bit of HapticSample::options_id: forces were off whatever the options say, as the loop left.
inline constexpr std::uint64_t kLeavingBit = std::uint64_t{1} << 63U;
/// Likewise: the window was silent for too long (ForceStopOptions::window_silent).
inline constexpr std::uint64_t kSilentBit = std::uint64_t{1} << 62U;
/// Likewise: nothing led, as the path that the options name was not the one that was there.
inline constexpr std::uint64_t kPathlessBit = std::uint64_t{1} << 61U;

}  // namespace relievo
