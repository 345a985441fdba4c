// SPDX-License-Identifier: BSD-3-Clause
#include "core/session/surface_colours.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <string>
#include <utility>

#include "core/base/error.h"
#include "core/depth/colour_fill.h"
#include "core/depth/point_rule.h"
#include "core/pyramid/colour_levels.h"
#include "core/region/window_colours.h"

namespace relievo {

GridColours windowColours(const Surface& surface, const RegionWindow& window, int ring) {
  if (surface.colours.empty()) return {};
  return windowColours(surface.colours, levelFrame(surface, window.region.level), window, ring);
}

GridColours levelColours(const Surface& surface, Level level, const LevelSamples& samples) {
  if (surface.colours.empty()) return {};
  const GridFrame& f = levelFrame(surface, level);
  const GridColours& from = surface.colours[static_cast<std::size_t>(level.value)];
  const GridFrame& finest = surface.map.frame;
  const double step = f.spacing_mm / finest.spacing_mm;
  const auto nearest = [step](int node, int count) {  // As levelCut.
    return std::min(static_cast<int>(std::lround(node * step)), count - 1);
  };
  GridColours cut;
  std::vector<Origin> origins;
  for (int row = samples.bottom; row <= samples.top; ++row) {
    const int r = nearest(row, finest.size.rows);
    for (int col = samples.left; col <= samples.right; ++col) {
      const Origin origin = surface.map.origin({.col = nearest(col, finest.size.cols), .row = r});
      origins.push_back(origin);
      const bool none = origin == Origin::base_plane || origin == Origin::outside;
      const std::size_t i = f.size.index({.col = col, .row = row});
      if (!from.colours.empty()) cut.colours.push_back(none ? Rgba{} : from.colours[i]);
      if (!from.intensities.empty()) {
        cut.intensities.push_back(none ? GreyAlpha{} : from.intensities[i]);
      }
    }
  }
  coverRim(cut, origins,
           {.cols = samples.right - samples.left + 1, .rows = samples.top - samples.bottom + 1});
  return cut;
}

GridColours levelColours(const Surface& surface, Level level) {
  if (surface.colours.empty()) return {};
  const GridSize size = levelFrame(surface, level).size;
  return levelColours(surface, level,
                      {.left = 0, .right = size.cols - 1, .bottom = 0, .top = size.rows - 1});
}

namespace {

/// "98.2 % of the measured cells"
std::string ownShare(const DepthMap& map, const std::function<std::uint8_t(std::size_t)>& alpha) {
  std::size_t measured = 0;
  std::size_t own = 0;
  for (std::size_t i = 0; i < map.origins.size(); ++i) {
    if (map.origins[i] != Origin::measured && map.origins[i] != Origin::steep) continue;
    ++measured;
    own += alpha(i) == kStoredAlpha ? 1 : 0;
  }
  std::array<char, 32> text{};
  std::snprintf(
      text.data(), text.size(), "%.3g %%",
      100 * static_cast<double>(own) / static_cast<double>(std::max<std::size_t>(measured, 1)));
  return std::string(text.data()) + " of the measured cells have one of their own";
}

std::string shortText(double number) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.6g", number);
  return text.data();
}

void sayColours(Surface& surface, const Scan& scan) {
  const GridColours& finest = surface.colours.front();
  if (!finest.colours.empty()) {
    surface.messages.push_back(
        "The scan has colours; " +
        ownShare(surface.map, [&](std::size_t i) { return finest.colours[i][3]; }) +
        ". The relief image 'natural' shows them.");
  }
  if (!finest.intensities.empty()) {
    const IntensityRange shown = shownIntensities(scan);
    surface.messages.push_back(
        "The scan has intensities; " +
        ownShare(surface.map, [&](std::size_t i) { return finest.intensities[i][1]; }) +
        ". The relief image 'intensity' shows them, black at " + shortText(shown.low) +
        " and white at " + shortText(shown.high) + ".");
  }
}

}  // namespace

void addColours(Surface& surface, const Scan& scan, const Task& task) {
  const DepthRequest request{
      .scan = scan, .view_from_file = surface.view_from_file, .frame = surface.map.frame};
  // The rule's name ends the words of how it was chosen.
  const bool front = surface.rule.ends_with(describe(PointRule::front));
  GridColours finest =
      gridColours(request, surface.map, front ? ColourRule::winner : ColourRule::layer, task);
  surface.colours = colourLevels(std::move(finest), surface.pyramid, 0, task);
  if (!surface.colours.empty()) sayColours(surface, scan);
}

void addColours(Surface& surface, GridColours&& finest, const Task& task) {
  surface.colours = colourLevels(std::move(finest), surface.pyramid, 0, task);
  if (surface.colours.empty()) return;
  surface.messages.emplace_back(
      "The map has colours beside it; the relief images 'natural' and 'intensity' show what there "
      "is.");
}

bool canShow(const Surface& surface, ReliefKind kind) {
  const bool any = !surface.colours.empty();
  if (kind == ReliefKind::natural) return any && !surface.colours.front().colours.empty();
  if (kind == ReliefKind::intensity) return any && !surface.colours.front().intensities.empty();
  return true;
}

void requireColours(const Surface& surface, ReliefKind kind) {
  if (canShow(surface, kind)) return;
  throw ArgumentError(kind == ReliefKind::natural
                          ? "The relief image 'natural' cannot be drawn: this surface has no "
                            "colours. Choose another, for example 'lit'."
                          : "The relief image 'intensity' cannot be drawn: this surface has no "
                            "intensities. Choose another, for example 'lit'.");
}

}  // namespace relievo
