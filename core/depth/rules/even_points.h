// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "core/base/task.h"
#include "core/base/vec3.h"

namespace relievo {

/// Hands out all points of a cloud in blocks, in the view in millimetres, in the file's order, each
/// time it is called: points in memory, or in a file that is larger than memory. Points with a
/// coordinate that is not finite do not count.
using ViewBlocks = std::function<void(const std::function<void(std::span<const ViewMm>)>& take)>;

struct ViewBox {
  ViewMm min, max;
};

/// About `wanted` points of a surface, the same share of it for each: the middle of those in every
/// cube of a grid, where there are more points than wanted; else all. Dense parts are thinned, and
/// their noise with them; sparse ones are not. The same points however they come in blocks. Keeps
/// 100 bytes a point that it returns. Coordinates from `box.min`. [worker]
/// @param count  of all points @throw Cancelled
std::vector<std::array<float, 3>> evenPoints(const ViewBlocks& points, const ViewBox& box,
                                             std::uint64_t count, std::size_t wanted,
                                             const Task& task);

}  // namespace relievo
