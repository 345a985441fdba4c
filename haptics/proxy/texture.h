// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "haptics/proxy/smooth_map.h"
#include "haptics/rt/realtime.h"
#include "haptics/space/haptic_space.h"

namespace relievo {

/// Prepares the texture of a filled space: how far the next finer level rises above the surface
/// that is touched. About 10 ms. [worker]
/// @param finer_mm  TextureMap::kCount heights of the next finer level, view mm, gain applied;
///                  place (i, j) at x_mm + (i + 0.5) side/400 of the region. Empty: no texture
/// @throw ArgumentError  another number of them, or one is not finite
void fillTexture(HapticSpace& space, std::span<const float> finer_mm);

/// Rise of the texture at a place of the window's grid, mm of hand, held within `most_mm`; its
/// slopes are pure numbers. Zero where there is no finer level. [haptic loop]
MapValue textureAt(const HapticSpace& space, double x, double y, double most_mm) RELIEVO_REALTIME;

/// Firmness, 0 .. 1, with its slopes per mm of hand. [haptic loop]
MapValue firmnessAt(const HapticSpace& space, double x, double y) RELIEVO_REALTIME;

}  // namespace relievo
