// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <type_traits>

#include "core/base/origin.h"
#include "core/base/vec3.h"
#include "core/region/window.h"
#include "haptics/rt/realtime.h"

namespace relievo {

/// Position in units of one cell of the window, the same in x, y and z: sample (i, j) lies at
/// (i, j), z is the height above mid height. The proxy is solved in this frame.
using GridPoint = Vec3<struct GridPointTag>;

/// The surface under the hand: one 200 x 200 window, paper sec. 4.1 and 6, with its place in the
/// hand's workspace. Fixed size and trivially copyable, so that it crosses threads by value inside
/// a TripleBuffer. One scale for x, y and z: the relief keeps its proportions at every level.
/// All const members: [any thread], real-time safe.
struct HapticSpace {
  std::array<float, kWindowCount> heights_mm{};      ///< View mm, row 0 at the lowest y.
  std::array<std::uint8_t, kWindowCount> origins{};  ///< Codes of `Origin`.
  double first_x_mm = 0.2, first_y_mm = 0.2;         ///< View position of sample (0, 0).
  double cell_mm = 0.4;                              ///< View mm from sample to sample.
  double mid_mm = 0;                                 ///< Height that lies at grid z = 0, view mm.
  double device_per_view = 1;                        ///< Hand mm per view mm.
  DeviceMm device_translation{-40, -40, 0};          ///< device = device_per_view * view + this.
  Region region{0, 0, 80, {}};
  std::uint64_t window_id = 0;  ///< Changes with every new window.
  std::int32_t detail = 1, levels = 1;

  double deviceMmPerCell() const RELIEVO_REALTIME { return cell_mm * device_per_view; }

  DeviceMm deviceFromView(ViewMm p) const RELIEVO_REALTIME {
    return {device_per_view * p.x + device_translation.x,
            device_per_view * p.y + device_translation.y,
            device_per_view * p.z + device_translation.z};
  }
  ViewMm viewFromDevice(DeviceMm p) const RELIEVO_REALTIME {
    return {(p.x - device_translation.x) / device_per_view,
            (p.y - device_translation.y) / device_per_view,
            (p.z - device_translation.z) / device_per_view};
  }
  GridPoint gridFromView(ViewMm p) const RELIEVO_REALTIME {
    return {(p.x - first_x_mm) / cell_mm, (p.y - first_y_mm) / cell_mm, (p.z - mid_mm) / cell_mm};
  }
  ViewMm viewFromGrid(GridPoint p) const RELIEVO_REALTIME {
    return {first_x_mm + cell_mm * p.x, first_y_mm + cell_mm * p.y, mid_mm + cell_mm * p.z};
  }
  GridPoint gridFromDevice(DeviceMm p) const RELIEVO_REALTIME {
    return gridFromView(viewFromDevice(p));
  }
  DeviceMm deviceFromGrid(GridPoint p) const RELIEVO_REALTIME {
    return deviceFromView(viewFromGrid(p));
  }

  /// Height of sample (col, row) in grid units; precondition: 0 <= col, row < 200.
  double gridHeight(int col, int row) const RELIEVO_REALTIME {
    const auto i = static_cast<std::size_t>(row) * kWindowSamples + static_cast<std::size_t>(col);
    return (static_cast<double>(heights_mm[i]) - mid_mm) * (1 / cell_mm);
  }
  /// Of the sample nearest (x, y); beyond the window that is one of its border.
  Origin originAt(GridPoint p) const RELIEVO_REALTIME;
};
static_assert(std::is_trivially_copyable_v<HapticSpace>);

/// Which step of the detail ladder a window is: Detail `detail` of `levels`, 1 the whole.
struct DetailStep {
  int detail = 1, levels = 1;
};

/// Copies a window and lays it into the hand's workspace (core's handMapping). [worker]
/// @throw ArgumentError  the window does not have 200 x 200 samples, or one is not finite
void fill(HapticSpace& space, const RegionWindow& window, DetailStep step);

}  // namespace relievo
