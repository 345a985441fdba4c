// SPDX-License-Identifier: BSD-3-Clause
#include "core/region/region.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/base/failure.h"
#include "core/region/window.h"

namespace relievo {
namespace {

constexpr double kSameSide = 1e-9;  // Relative; sides closer than this are the same detail.

double clampedStart(double start, double side, double low, double extent) {
  if (side >= extent) return low + 0.5 * (extent - side);
  return std::clamp(start, low, low + extent - side);
}

Region keptOnMap(const DetailLadder& ladder, Region region) {
  region.x_mm = clampedStart(region.x_mm, region.side_mm, ladder.left_mm, ladder.width_mm);
  region.y_mm = clampedStart(region.y_mm, region.side_mm, ladder.bottom_mm, ladder.height_mm);
  return region;
}

Region regionOfDetail(const DetailLadder& ladder, int detail, const Region& from,
                      const StepAbout& about) {
  if (detail == 1) return wholeRegion(ladder);
  const double side = ladder.sideMm(detail);
  Region to{.side_mm = side, .level = {ladder.levels() - detail}};
  if (about.touching) {
    // The touched point keeps its place in the window, so that the hand need not move.
    to.x_mm = about.x_mm - (about.x_mm - from.x_mm) / from.side_mm * side;
    to.y_mm = about.y_mm - (about.y_mm - from.y_mm) / from.side_mm * side;
    return to;
  }
  to.x_mm = about.x_mm - 0.5 * side;
  to.y_mm = about.y_mm - 0.5 * side;
  return keptOnMap(ladder, to);
}

void requireLevel(const DetailLadder& ladder, Level level) {
  if (level.value >= 0 && level.value < ladder.levels()) return;
  throw failure<MessageId::no_such_level>(level.value, ladder.levels() - 1);
}

}  // namespace

double DetailLadder::sideMm(int detail) const noexcept {
  if (detail <= 1) return std::max(width_mm, height_mm);
  return kWindowSamples * spacings_mm[static_cast<std::size_t>(levels() - detail)];
}

DetailLadder detailLadder(const DepthMap& map, const Pyramid& pyramid) {
  DetailLadder ladder{.left_mm = map.leftMm(),
                      .bottom_mm = map.bottomMm(),
                      .width_mm = map.widthMm(),
                      .height_mm = map.heightExtentMm(),
                      .spacings_mm = {},
                      .factor = pyramid.factor};
  for (const PyramidLevel& level : pyramid.levels) {
    ladder.spacings_mm.push_back(level.frame.spacing_mm);
  }
  return ladder;
}

Region wholeRegion(const DetailLadder& ladder) {
  const double side = ladder.sideMm(1);
  return keptOnMap(ladder, {.x_mm = ladder.left_mm,
                            .y_mm = ladder.bottom_mm,
                            .side_mm = side,
                            .level = {ladder.levels() - 1}});
}

Level defaultLevel(const DetailLadder& ladder, double side_mm) {
  const double wanted = side_mm / kWindowSamples / std::sqrt(ladder.factor) * (1 - kSameSide);
  for (int level = 0; level < ladder.levels(); ++level) {
    if (ladder.spacings_mm[static_cast<std::size_t>(level)] >= wanted) return {level};
  }
  return {ladder.levels() - 1};
}

Region regionFromRect(const DetailLadder& ladder, const RectMm& rect, std::optional<Level> level) {
  const double side = std::max(rect.width_mm, rect.height_mm);
  const bool finite = std::isfinite(rect.x_mm) && std::isfinite(rect.y_mm) &&
                      std::isfinite(rect.width_mm) && std::isfinite(rect.height_mm);
  if (!finite || !(rect.width_mm > 0) || !(rect.height_mm > 0)) {
    throw failure<MessageId::region_without_size>();
  }
  if (level) requireLevel(ladder, *level);
  return {.x_mm = rect.x_mm + 0.5 * (rect.width_mm - side),
          .y_mm = rect.y_mm + 0.5 * (rect.height_mm - side),
          .side_mm = side,
          .level = level.value_or(defaultLevel(ladder, side))};
}

std::optional<Region> finer(const DetailLadder& ladder, const Region& from,
                            const StepAbout& about) {
  for (int detail = 1; detail <= ladder.levels(); ++detail) {
    if (ladder.sideMm(detail) < from.side_mm * (1 - kSameSide)) {
      return regionOfDetail(ladder, detail, from, about);
    }
  }
  return std::nullopt;
}

std::optional<Region> coarser(const DetailLadder& ladder, const Region& from,
                              const StepAbout& about) {
  for (int detail = ladder.levels(); detail >= 1; --detail) {
    if (ladder.sideMm(detail) > from.side_mm * (1 + kSameSide)) {
      return regionOfDetail(ladder, detail, from, about);
    }
  }
  return std::nullopt;
}

std::optional<Region> moved(const DetailLadder& ladder, const Region& from, double dx, double dy) {
  Region to = from;
  to.x_mm += dx * from.side_mm;
  to.y_mm += dy * from.side_mm;
  to = keptOnMap(ladder, to);
  if (to == from) return std::nullopt;
  return to;
}

std::optional<Region> atLevel(const DetailLadder& ladder, const Region& from, Level level) {
  if (level.value < 0 || level.value >= ladder.levels() || level == from.level) return std::nullopt;
  Region to = from;
  to.level = level;
  return to;
}

bool onMap(const DetailLadder& ladder, const Region& region) noexcept {
  return region.x_mm < ladder.left_mm + ladder.width_mm &&
         region.x_mm + region.side_mm > ladder.left_mm &&
         region.y_mm < ladder.bottom_mm + ladder.height_mm &&
         region.y_mm + region.side_mm > ladder.bottom_mm;
}

}  // namespace relievo
