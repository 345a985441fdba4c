// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <type_traits>

#include "core/base/origin.h"
#include "core/base/vec3.h"
#include "core/region/window.h"
#include "haptics/rt/realtime.h"

namespace relievo {

/// Position in units of one cell of the window, the same in x, y and z: sample (i, j) lies at
/// (i, j), z is the height above mid height. The proxy is solved in this frame.
using GridPoint = Vec3<struct GridPointTag>;

/// How the surface runs between the samples; docs/adr/0020.
enum class SurfaceKind : std::uint8_t {
  crease_aware,  ///< C2 spline that breaks at walls, creases and hole rims; the default.
  spline,    ///< C2 interpolating bicubic spline everywhere: smooth relief only, rings at walls.
  bilinear,  ///< The paper's: flat ruled facets, exact at walls, a crease at every line of samples.
};

/// What the surface is made from at one sample. Slopes are pure numbers (grid units both ways);
/// where the sample breaks in a direction the slope in that direction is the mean of both sides and
/// cells find their own (haptics/space/cell.h).
struct SurfaceSample {
  float height_mm = 0;  ///< View mm.
  float slope_x = 0, slope_y = 0;
  float twist = 0;  ///< d2f / dx dy, per cell.
};

/// Bits of `HapticSpace::marks`.
inline constexpr std::uint8_t kBreakX = 1;      ///< The surface has a crease across x here.
inline constexpr std::uint8_t kBreakY = 2;      ///< ... across y.
inline constexpr std::uint8_t kSmoothCell = 4;  ///< No corner of cell (i, j) breaks.

/// Highest points of square blocks of cells; a ray above a block passes it in one step.
struct BlockTops {
  static constexpr std::array<int, 3> kShift{6, 4, 2};  ///< 64, 16 and 4 cells wide.
  static constexpr std::array<int, 3> kBlocks{(kWindowSamples >> 6) + 1, (kWindowSamples >> 4) + 1,
                                              (kWindowSamples >> 2) + 1};
  std::array<float, std::size_t{kBlocks[0]} * kBlocks[0]> coarse{};
  std::array<float, std::size_t{kBlocks[1]} * kBlocks[1]> middle{};
  std::array<float, std::size_t{kBlocks[2]} * kBlocks[2]> fine{};

  static constexpr std::size_t index(std::size_t level, int col, int row) RELIEVO_REALTIME {
    const auto block_col = static_cast<std::size_t>(col >> kShift[level]);
    const auto block_row = static_cast<std::size_t>(row >> kShift[level]);
    return block_row * static_cast<std::size_t>(kBlocks[level]) + block_col;
  }
  float at(std::size_t level, int col, int row) const RELIEVO_REALTIME {
    const std::size_t i = index(level, col, row);
    if (level == 0) return coarse[i];
    return level == 1 ? middle[i] : fine[i];
  }
};

/// What lies between the samples of a window and is too fine for its surface: how far the next
/// finer level rises above it, at twice as many places per side. One byte per place.
struct TextureMap {
  static constexpr int kSamples = 2 * kWindowSamples;
  static constexpr std::size_t kCount = std::size_t{kSamples} * kSamples;
  std::array<std::int8_t, kCount> rise_um{};  ///< Micrometres of hand; row 0 at the lowest y.
  bool present = false;                       ///< There is a finer level.
};

/// The surface under the hand: one 200 x 200 window, paper sec. 4.1 and 6, with its place in the
/// hand's workspace. Fixed size and trivially copyable, so that it crosses threads by value inside
/// a SceneBuffer. One scale for x, y and z: the relief keeps its proportions at every level.
/// All const members: [any thread], real-time safe.
struct HapticSpace {
  std::array<SurfaceSample, kWindowCount> samples{};  ///< Row 0 at the lowest y.
  std::array<float, kWindowCount> cell_tops{};  ///< No point of cell (i, j) is higher, grid z.
  BlockTops block_tops;
  std::array<std::uint8_t, kWindowCount> marks{};    ///< Breaks.
  std::array<std::uint8_t, kWindowCount> origins{};  ///< Codes of `CellStatus`.
  /// 0 .. 255: from as soft as the ground gets here to the full stiffness; smooth over some cells.
  std::array<std::uint8_t, kWindowCount> firmness{};
  bool firm_everywhere = true;
  TextureMap texture;
  SurfaceKind surface = SurfaceKind::bilinear;
  double first_x_mm = 0.2, first_y_mm = 0.2;  ///< View position of sample (0, 0).
  double cell_mm = 0.4;                       ///< View mm from sample to sample.
  double cells_per_mm = 2.5;                  ///< 1 / cell_mm.
  double mid_mm = 0;                          ///< Height that lies at grid z = 0, view mm.
  double device_per_view = 1;                 ///< Hand mm per view mm.
  DeviceMm device_translation{-40, -40, 0};   ///< device = device_per_view * view + this.
  Region region{0, 0, 80, {}};
  std::uint64_t window_id = 0;  ///< Changes with every new window.
  std::uint64_t scene_id = 0;   ///< Given by whoever fills; names this very filling in recordings.
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

  static std::size_t index(int col, int row) RELIEVO_REALTIME {
    return static_cast<std::size_t>(row) * kWindowSamples + static_cast<std::size_t>(col);
  }
  /// Height of sample (col, row) in grid units; precondition: 0 <= col, row < 200.
  double gridHeight(int col, int row) const RELIEVO_REALTIME {
    return (static_cast<double>(samples[index(col, row)].height_mm) - mid_mm) * cells_per_mm;
  }
  /// Of the sample nearest (x, y); beyond the window that is one of its border.
  CellStatus originAt(GridPoint p) const RELIEVO_REALTIME;
};
static_assert(std::is_trivially_copyable_v<HapticSpace>);
static_assert(sizeof(HapticSpace) - sizeof(TextureMap) <= 24 * kWindowCount,
              "24 bytes per sample of the surface in all, and one per place of the texture");

/// Which step of the detail ladder a window is: Detail `detail` of `levels`, 1 the whole.
struct DetailStep {
  int detail = 1, levels = 1;
};

/// A point of the object that is to stay where it is in the hand's space: what is being touched.
struct Anchor {
  ViewMm point;
  DeviceMm at;
};

/// The device's cube of about 4 inches, less a margin.
inline constexpr DeviceMm kHandReach{48, 48, 42};

/// core's handMapping; with an anchor moved so that its point lies where it was, as far as all of
/// the window stays within kHandReach.
HandMapping mappingOf(const RegionWindow& window, const std::optional<Anchor>& anchor = {});

/// Over how many samples to either side a change of firmness is spread: 2.4 mm of hand at most.
inline constexpr int kFirmnessReach = 6;

/// Copies a window, lays it into the hand's workspace (mappingOf) and prepares the surface between
/// its samples. About 10 ms. [worker]
/// Texture is a step of its own (haptics/proxy/texture.h).
/// @param firmness  kWindowCount numbers in [0, 1], row 0 at the lowest y: 1 where the ground is
///                  firm. Empty: firm where the window's origins say measured or steep
/// @throw ArgumentError  the window does not have 200 x 200 samples, or one is not finite; a
///                       firmness of another size, or a number of it outside [0, 1]
void fill(HapticSpace& space, const RegionWindow& window, DetailStep step,
          SurfaceKind kind = SurfaceKind::crease_aware, const std::optional<Anchor>& anchor = {},
          std::span<const float> firmness = {});

}  // namespace relievo
