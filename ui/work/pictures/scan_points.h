// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/base/task.h"
#include "core/cloud/scan.h"
#include "ui/vtk/cloud/cloud_scene.h"

namespace relievo {

/// How many points are drawn at most, so that a view turns smoothly.
inline constexpr std::size_t kMostShownPoints = 400'000;

/// Those points of a scan that are drawn, and what is known of them.
struct ShownPoints {
  std::vector<std::uint32_t> numbers;         ///< In the scan, rising.
  std::vector<std::array<float, 3>> normals;  ///< Of these; 0 0 0: not known.
  double spacing = 0;                         ///< Of these, file units.
};

/// Points evenly along the file, so that a scanner's rows are all thinned alike.
/// @param most  points [worker] @throw Cancelled
ShownPoints shownPoints(const Scan& scan, std::size_t most, const Task& task);

/// The colour of a point: its own, else its intensity as grey, else that of stone. sRGB.
std::array<std::uint8_t, 3> shownColour(const Scan& scan, std::size_t point);

/// A scan as it is stored, in its own colours: its triangles if it has some and not more than
/// `most`, nor three times as many points; else points, at most `most`. [worker] @throw Cancelled
CloudPoints drawnScan(const Scan& scan, std::size_t most, const Task& task);

}  // namespace relievo
