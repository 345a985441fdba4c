// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/proxy/texture.h"

#include <cmath>
#include <limits>
#include <string>

#include "core/base/failure.h"
#include "haptics/proxy/surface.h"

namespace relievo {

namespace {
constexpr double kUmPerMm = 1000;

/// Two places of the texture lie in each cell and direction: 2 x + 0.5.
double placeOf(double grid) RELIEVO_REALTIME {
  return 2 * grid + 0.5;
}
double gridOf(int place) {
  return 0.5 * place - 0.25;
}
}  // namespace

void fillTexture(HapticSpace& space, std::span<const float> finer_mm) {
  TextureMap& texture = space.texture;
  texture.present = false;
  if (finer_mm.empty()) return;
  const bool finite = std::all_of(finer_mm.begin(), finer_mm.end(),
                                  [](float height) { return std::isfinite(height); });
  if (finer_mm.size() != TextureMap::kCount || !finite) {
    throw failure<MessageId::texture_of_another_size>(finer_mm.size());
  }
  constexpr double kMost = std::numeric_limits<std::int8_t>::max();
  std::size_t i = 0;
  for (int row = 0; row < TextureMap::kSamples; ++row) {
    for (int col = 0; col < TextureMap::kSamples; ++col, ++i) {
      const double surface = surfaceHeight(space, gridOf(col), gridOf(row));
      const double finer = (static_cast<double>(finer_mm[i]) - space.mid_mm) * space.cells_per_mm;
      const double rise_um = kUmPerMm * (finer - surface) * space.deviceMmPerCell();
      texture.rise_um[i] =
          static_cast<std::int8_t>(std::lround(std::clamp(rise_um, -kMost, kMost)));
    }
  }
  texture.present = true;
}

MapValue textureAt(const HapticSpace& space, double x, double y, double most_mm) RELIEVO_REALTIME {
  if (!space.texture.present) return {};
  const double most_um = kUmPerMm * most_mm;
  MapValue rise = smoothMap(
      TextureMap::kSamples, placeOf(x), placeOf(y), [&](int col, int row) RELIEVO_REALTIME {
        const auto i =
            static_cast<std::size_t>(row) * TextureMap::kSamples + static_cast<std::size_t>(col);
        return std::clamp<double>(space.texture.rise_um[i], -most_um, most_um);
      });
  rise.value /= kUmPerMm;
  const double place_mm = 0.5 * space.deviceMmPerCell();
  rise.along_x /= kUmPerMm * place_mm;
  rise.along_y /= kUmPerMm * place_mm;
  return rise;
}

MapValue firmnessAt(const HapticSpace& space, double x, double y) RELIEVO_REALTIME {
  if (space.firm_everywhere) return {1, 0, 0};
  MapValue firmness = smoothMap(kWindowSamples, x, y, [&](int col, int row) RELIEVO_REALTIME {
    return space.firmness[HapticSpace::index(col, row)] / 255.0;
  });
  firmness.along_x /= space.deviceMmPerCell();
  firmness.along_y /= space.deviceMmPerCell();
  return firmness;
}

}  // namespace relievo
