// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/depth/colours/colours.h"

namespace relievo {

// Samples of a mesh, for core/depth/colours/colours.cpp: of the front-most triangle at each. Cells
// that are not measured, and hits without a colour, have alpha 0. [worker] @throw Cancelled

/// From textures where triangles have them, else between the colours of their corners.
std::vector<Rgba> meshColours(const DepthRequest& request, const DepthMap& map, const Task& task);

/// @param light  of every point, 0 ... Transfer::kMost
std::vector<GreyAlpha> meshIntensities(const DepthRequest& request, const DepthMap& map,
                                       std::span<const std::uint16_t> light, const Task& task);

}  // namespace relievo
