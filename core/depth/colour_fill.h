// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/task.h"
#include "core/depth/depth_map.h"
#include "core/depth/linear_light.h"

namespace relievo {

/// A stored sample: its channels and, last, alpha.
template <std::size_t Channels>
using Pixel = std::array<std::uint8_t, Channels + 1>;

/// Gives interpolated cells, and measured ones without a colour of their own that lie within
/// `kBareReach` cells of one that has one, the mean of the colours around them, in linear light
/// weighted by how near they are (push-pull, as core/depth/push_pull.h). Their alpha becomes 128.
/// For Pixel<3> and Pixel<1>. @throw Cancelled
template <std::size_t Channels>
void fillColours(std::vector<Pixel<Channels>>& pixels, const DepthMap& map,
                 const Transfer& transfer, const Task& task);

struct GridColours;  // core/depth/colours.h
/// The same for a finished map some of whose holes were filled since. [worker] @throw Cancelled
void fillColours(GridColours& colours, const DepthMap& map, const Task& task);

/// Gives samples outside the object the colour of one beside them that lies on it: a picture's
/// outline runs half a sample beyond the object and would be stone. [any thread]
void coverRim(GridColours& colours, std::span<const Origin> origins, GridSize size);

inline constexpr int kBareReach = 8;  ///< Side of the squares one of whose cells must have one.

}  // namespace relievo
