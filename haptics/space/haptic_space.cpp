// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/space/haptic_space.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/base/error.h"
#include "haptics/space/surface_fit.h"

namespace relievo {

namespace {
void requireComplete(const RegionWindow& window) {
  if (window.heights_mm.size() != kWindowCount || window.origins.size() != kWindowCount) {
    throw ArgumentError("The window has " + std::to_string(window.heights_mm.size()) +
                        " samples; the haptic space holds exactly 200 x 200.");
  }
  if (!std::all_of(window.heights_mm.begin(), window.heights_mm.end(),
                   [](float h) { return std::isfinite(h); })) {
    throw ArgumentError(
        "The window has a height that is not a finite number; nothing can be felt.");
  }
  if (!(window.region.side_mm > 0) || !std::isfinite(window.region.side_mm)) {
    throw ArgumentError("The window's side is " + std::to_string(window.region.side_mm) +
                        " mm; it must be greater than 0.");
  }
}
}  // namespace

Origin HapticSpace::originAt(GridPoint p) const RELIEVO_REALTIME {
  constexpr double kLast = kWindowSamples - 1;
  const auto col = static_cast<std::size_t>(std::lround(std::clamp(p.x, 0.0, kLast)));
  const auto row = static_cast<std::size_t>(std::lround(std::clamp(p.y, 0.0, kLast)));
  return static_cast<Origin>(origins[row * kWindowSamples + col]);
}

HandMapping mappingOf(const RegionWindow& window, const std::optional<Anchor>& anchor) {
  HandMapping mapping = handMapping(window);
  if (!anchor || !isFinite(anchor->point) || !isFinite(anchor->at)) return mapping;
  const double scale = mapping.device_per_view;
  const DeviceMm shift = anchor->at - mapping.device_from_view(anchor->point);
  const double half_side = 0.5 * scale * window.region.side_mm;
  const double half_height =
      0.5 * scale * (static_cast<double>(window.max_mm) - static_cast<double>(window.min_mm));
  const auto within = [](double wanted, double half_size, double reach) {
    const double most = std::max(0.0, reach - half_size);
    return std::clamp(wanted, -most, most);
  };
  auto& m = mapping.device_from_view.m;
  m[3] += within(shift.x, half_side, kHandReach.x);
  m[7] += within(shift.y, half_side, kHandReach.y);
  m[11] += within(shift.z, half_height, kHandReach.z);
  return mapping;
}

void fill(HapticSpace& space, const RegionWindow& window, DetailStep step, SurfaceKind kind,
          const std::optional<Anchor>& anchor) {
  requireComplete(window);
  const HandMapping mapping = mappingOf(window, anchor);
  std::transform(window.heights_mm.begin(), window.heights_mm.end(), space.samples.begin(),
                 [](float h) {
                   return SurfaceSample{h, 0, 0, 0};
                 });
  std::transform(window.origins.begin(), window.origins.end(), space.origins.begin(),
                 [](Origin o) { return static_cast<std::uint8_t>(o); });
  space.cell_mm = window.spacingMm();
  space.cells_per_mm = 1 / space.cell_mm;
  space.first_x_mm = window.region.x_mm + 0.5 * space.cell_mm;
  space.first_y_mm = window.region.y_mm + 0.5 * space.cell_mm;
  space.mid_mm = 0.5 * (static_cast<double>(window.min_mm) + static_cast<double>(window.max_mm));
  space.device_per_view = mapping.device_per_view;
  const auto& m = mapping.device_from_view.m;
  space.device_translation = {m[3], m[7], m[11]};
  space.region = window.region;
  space.window_id = window.id;
  space.detail = step.detail;
  space.levels = step.levels;
  fitSurface(space, kind);
}

}  // namespace relievo
