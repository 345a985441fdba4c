// SPDX-License-Identifier: BSD-3-Clause
#include "ui/video/video_surface.h"

#include <algorithm>
#include <cmath>

#include "core/relief/relief_image.h"
#include "core/session/colours/surface_colours.h"
#include "core/session/large/crop_level.h"
#include "core/session/large/tiled_surface.h"

namespace relievo {
namespace {

constexpr double kEnoughSamples = 400;  // Across a picture of video size.

/// The rectangle widened to a raster that depends on its size alone: a camera that moves needs a
/// new cut only now and then, and a frame does not depend on those before it.
RectMm widened(const RectMm& rect) {
  const double longer = std::max(rect.width_mm, rect.height_mm);
  const double step = 0.5 * std::exp2(std::ceil(std::log2(longer)));
  const double x = std::floor(rect.x_mm / step) * step;
  const double y = std::floor(rect.y_mm / step) * step;
  return {x, y, std::ceil((rect.x_mm + rect.width_mm) / step) * step - x,
          std::ceil((rect.y_mm + rect.height_mm) / step) * step - y};
}

/// The coarsest level with enough samples across; the finest if there is none.
int levelFor(const DetailLadder& ladder, double width_mm) {
  int level = ladder.levels() - 1;
  while (level > 0 &&
         width_mm / ladder.spacings_mm[static_cast<std::size_t>(level)] < kEnoughSamples) {
    --level;
  }
  return level;
}

LevelSamples samplesIn(const Surface& surface, int level, const RectMm& rect) {
  const GridFrame& f = levelFrame(surface, {level});
  const auto index = [&](double at, double first, int count) {
    return std::clamp(static_cast<int>(std::lround((at - first) / f.spacing_mm)), 0, count - 1);
  };
  return {.left = index(rect.x_mm, f.first_x_mm, f.size.cols),
          .right = index(rect.x_mm + rect.width_mm, f.first_x_mm, f.size.cols),
          .bottom = index(rect.y_mm, f.first_y_mm, f.size.rows),
          .top = index(rect.y_mm + rect.height_mm, f.first_y_mm, f.size.rows)};
}

}  // namespace

void VideoSurface::show(ReliefScene& scene, const DepthMap& map, const GridColours& own) {
  requireColours(surface_, look_.kind);
  std::vector<std::uint8_t> colours;
  if (look_.kind != ReliefKind::lit) colours = reliefColours(reliefValues(map, look_), look_, own);
  scene.setSurface({map.frame, &map.heights_mm, &map.origins, colours.empty() ? nullptr : &colours,
                    isLit(look_.kind)});
  scene.setInterpolated(interpolatedMark(look_));
  const HeightRange range = heightRange(map);
  mid_height_mm_ = 0.5 * (range.min_mm + range.max_mm);
}

void VideoSurface::showWindow(ReliefScene& scene, const Region& region, double gain) {
  if (window_ == region && gain_ == gain) return;
  window_ = region;
  part_.reset();
  gain_ = gain;
  const RegionWindow window = relievo::windowOf(surface_, region, gain);
  show(scene, windowMap(window), windowColours(surface_, window));
}

void VideoSurface::showPart(ReliefScene& scene, const RectMm& rect, double gain) {
  const int level = levelFor(surface_.ladder, std::max(rect.width_mm, rect.height_mm));
  const RectMm part = widened(rect);
  if (part_ == part && part_level_ == level && gain_ == gain) return;
  part_ = part;
  part_level_ = level;
  gain_ = gain;
  window_.reset();
  const LevelSamples samples = samplesIn(surface_, level, *part_);
  show(scene, cropLevel(surface_, {level}, samples, gain),
       levelColours(surface_, {level}, samples));
}

}  // namespace relievo
