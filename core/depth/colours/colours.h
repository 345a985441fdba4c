// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/base/task.h"
#include "core/cloud/scan.h"
#include "core/depth/depth_map.h"
#include "core/depth/depth_request.h"

namespace relievo {

/// Intensity for the screen, and alpha.
using GreyAlpha = std::array<std::uint8_t, 2>;

/// What a scan says of the samples of a grid beside their heights. Each list is empty, or in the
/// order and number of the heights. Alpha of the finest level: 255 from the scan, 128 interpolated,
/// 0 none; of coarser levels: the share that comes from the scan, at least 1 where there is any
/// colour. Four bytes a sample for colours, two for intensities.
struct GridColours {
  std::vector<Rgba> colours;  ///< sRGB, not multiplied by alpha.
  std::vector<GreyAlpha> intensities;

  bool empty() const noexcept { return colours.empty() && intensities.empty(); }
  friend bool operator==(const GridColours&, const GridColours&) = default;
};
inline constexpr std::uint8_t kStoredAlpha = 255;
inline constexpr std::uint8_t kBetweenAlpha = 128;

/// Does the scan say any colour, on its points or as textures? Fields that hold none do not count.
bool hasColours(const Scan& scan);
bool hasIntensities(const Scan& scan);

/// Whose colours a cell of a cloud gets.
enum class ColourRule {
  layer,   ///< The mean in linear light of the points that make its height.
  winner,  ///< That of its front-most point alone, whose height it has.
};
inline constexpr double kColourDepthCells = 1.5;  ///< Half the depth of that layer, in samples.

/// Colours and intensities of the samples from what gave them their heights. Clouds: the points of
/// the cell within `kColourDepthCells` spacings of its height, so that neither outliers nor the
/// back leave a trace. Meshes: the front-most triangle at the sample, from its corners or its
/// texture at the fineness of the cell. Cells between them by push-pull; holes, outside and cells
/// far from any colour have none. Intensities spread their middle 96 % over 0 ... 255. The same
/// bytes for any number of threads. [worker]
/// @param request  its view_from_file is that of the finished map: z above the base plane
/// @param map  on request.frame
/// @throw Cancelled
GridColours gridColours(const DepthRequest& request, const DepthMap& map, ColourRule rule,
                        const Task& task = {});

/// Which stored intensities 0 and 255 of GridColours::intensities stand for, as numbers of the file
/// if it says its range. @pre hasIntensities(scan)
IntensityRange shownIntensities(const Scan& scan);

}  // namespace relievo
