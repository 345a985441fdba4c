// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace relievo {

/// Corner numbers of a triangle within its polygon.
using PolygonTriangle = std::array<std::uint32_t, 3>;

/// Cuts a polygon into triangles of its own orientation. A convex one, seen along its own normal,
/// becomes the fan of its first corner; any other is cut ear by ear, so that no triangle lies
/// outside of it. A triangle with a corner place twice may come out; it has no area.
/// @param corners    in order, at least 3; need not lie in one plane
/// @param triangles  overwritten
/// @return  false if it has too many corners (4096) to be cut by ears in good time, and became a
/// fan
///          although it is not convex
bool cutPolygon(std::span<const std::array<float, 3>> corners,
                std::vector<PolygonTriangle>& triangles);

}  // namespace relievo
