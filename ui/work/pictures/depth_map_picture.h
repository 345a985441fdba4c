// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <QImage>
#include <vector>

#include "core/session/surface.h"

namespace relievo {

/// What a depth map looks like before it is taken: pictures and counts, made once off the GUI
/// thread.
struct DepthMapPicture {
  QImage shaded;            ///< Hillshaded; outside is transparent.
  QImage mask;              ///< Same size: what was not measured, by colour and pattern.
  std::vector<int> counts;  ///< Of measured cells by height, from low to high.
  double low_mm = 0, high_mm = 0;
  std::array<double, kOriginCount> shares{};
};
/// [worker] @throw Cancelled
DepthMapPicture pictureOf(const DepthMap& map, const Task& task = {});
DepthMapPicture pictureOf(const Surface& surface, const Task& task = {});

}  // namespace relievo
