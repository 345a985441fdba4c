// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/space/haptic_space.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/base/failure.h"
#include "haptics/space/surface_fit.h"

namespace relievo {

namespace {
void requireComplete(const RegionWindow& window) {
  if (window.heights_mm.size() != kWindowCount || window.origins.size() != kWindowCount) {
    throw failure<MessageId::window_of_another_size>(window.heights_mm.size());
  }
  if (!std::all_of(window.heights_mm.begin(), window.heights_mm.end(),
                   [](float h) { return std::isfinite(h); })) {
    throw failure<MessageId::window_not_finite>();
  }
  if (!(window.region.side_mm > 0) || !std::isfinite(window.region.side_mm)) {
    throw failure<MessageId::window_without_side>(
        NumberArgument{.value = window.region.side_mm, .digits = 6});
  }
}

void requireShares(std::span<const float> firmness) {
  if (firmness.empty()) return;
  const bool shares = std::all_of(firmness.begin(), firmness.end(),
                                  [](float part) { return part >= 0 && part <= 1; });
  if (firmness.size() != kWindowCount || !shares) {
    throw failure<MessageId::firmness_of_window>();
  }
}

bool isFirm(CellStatus origin) {
  return origin == CellStatus::measured || origin == CellStatus::steep;
}

/// The mean over 7 samples, twice, along lines of samples `step` apart; beyond its ends a line
/// goes on as it ends.
void spread(std::vector<float>& values, std::size_t step, std::size_t across) {
  constexpr int kReach = kFirmnessReach / 2, kLast = kWindowSamples - 1;
  std::vector<float> line(kWindowSamples);
  for (std::size_t start = 0; start < kWindowSamples; ++start) {
    for (int pass = 0; pass < 2; ++pass) {
      for (std::size_t i = 0; i < kWindowSamples; ++i) line[i] = values[start * across + i * step];
      for (int i = 0; i <= kLast; ++i) {
        float sum = 0;
        for (int k = i - kReach; k <= i + kReach; ++k) {
          sum += line[static_cast<std::size_t>(std::clamp(k, 0, kLast))];
        }
        values[start * across + static_cast<std::size_t>(i) * step] = sum / (2 * kReach + 1);
      }
    }
  }
}

/// A hand must be able to glide from firm to soft: a step would push it.
void fillFirmness(HapticSpace& space, const RegionWindow& window, std::span<const float> firmness) {
  constexpr float kFull = 255;
  std::vector<float> parts(firmness.begin(), firmness.end());
  if (parts.empty()) {
    parts.resize(kWindowCount);
    std::transform(window.origins.begin(), window.origins.end(), parts.begin(),
                   [](CellStatus origin) { return isFirm(origin) ? 1.0F : 0.0F; });
  }
  space.firm_everywhere =
      std::all_of(parts.begin(), parts.end(), [](float part) { return part >= 1; });
  if (!space.firm_everywhere) {
    spread(parts, 1, kWindowSamples);
    spread(parts, kWindowSamples, 1);
  }
  std::transform(parts.begin(), parts.end(), space.firmness.begin(), [](float part) {
    return static_cast<std::uint8_t>(std::lround(kFull * std::clamp(part, 0.0F, 1.0F)));
  });
}
}  // namespace

CellStatus HapticSpace::originAt(GridPoint p) const RELIEVO_REALTIME {
  constexpr double kLast = kWindowSamples - 1;
  const auto col = static_cast<std::size_t>(std::lround(std::clamp(p.x, 0.0, kLast)));
  const auto row = static_cast<std::size_t>(std::lround(std::clamp(p.y, 0.0, kLast)));
  return static_cast<CellStatus>(origins[row * kWindowSamples + col]);
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
          const std::optional<Anchor>& anchor, std::span<const float> firmness) {
  requireComplete(window);
  requireShares(firmness);
  const HandMapping mapping = mappingOf(window, anchor);
  std::transform(window.heights_mm.begin(), window.heights_mm.end(), space.samples.begin(),
                 [](float h) {
                   return SurfaceSample{h, 0, 0, 0};
                 });
  std::transform(window.origins.begin(), window.origins.end(), space.origins.begin(),
                 [](CellStatus o) { return static_cast<std::uint8_t>(o); });
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
  space.scene_id = 0;
  space.detail = step.detail;
  space.levels = step.levels;
  fillFirmness(space, window, firmness);
  space.texture.present = false;
  fitSurface(space, kind);
}

}  // namespace relievo
