// SPDX-License-Identifier: BSD-3-Clause
#include "core/session/colours/surface_colours.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <utility>

#include "core/base/failure.h"
#include "core/depth/colours/cell_colours.h"
#include "core/depth/colours/colour_fill.h"
#include "core/depth/rules/point_rule.h"
#include "core/pyramid/colour_levels.h"
#include "core/region/window_colours.h"
#include "core/session/loss_report.h"
#include "core/tiles/tiled_map.h"

namespace relievo {

GridColours windowColours(const Surface& surface, const RegionWindow& window, int ring) {
  if (surface.tiles) return surface.tiles->windowColours(window, ring);
  if (surface.colours.empty()) return {};
  const GridFrame& nodes = levelFrame(surface, window.region.level);
  const StoredColours& level = surface.colours[static_cast<std::size_t>(window.region.level.value)];
  return windowColours(nodesOf(level, nodes.size), nodes, window, ring);
}

namespace {

/// Colours of a part of a level's nodes as they are kept.
GridColours partColours(const Surface& surface, Level level, Cell first, GridSize size) {
  if (surface.tiles) return surface.tiles->partColours(level, first, size);
  const StoredColours& from = surface.colours[static_cast<std::size_t>(level.value)];
  const GridSize nodes = levelFrame(surface, level).size;
  GridColours part;
  if (from.hasColours()) part.colours.resize(size.count());
  if (from.hasIntensities()) part.intensities.resize(size.count());
  const auto cols = static_cast<std::size_t>(size.cols);
  for (int row = 0; row < size.rows; ++row) {
    const std::size_t start = nodes.index({.col = first.col, .row = first.row + row});
    const std::size_t to = size.index({.col = 0, .row = row});
    if (from.hasColours()) from.read(start, std::span(part.colours).subspan(to, cols));
    if (from.hasIntensities()) from.read(start, std::span(part.intensities).subspan(to, cols));
  }
  return part;
}

}  // namespace

GridColours levelColours(const Surface& surface, Level level, const LevelSamples& samples) {
  if (!surface.tiles && surface.colours.empty()) return {};
  const GridSize size{.cols = samples.right - samples.left + 1,
                      .rows = samples.top - samples.bottom + 1};
  GridColours cut = partColours(surface, level, {.col = samples.left, .row = samples.bottom}, size);
  if (cut.empty()) return cut;
  const std::vector<CellStatus> origins = cropLevel(surface, level, samples, 1).origins;
  for (std::size_t i = 0; i < origins.size(); ++i) {
    if (origins[i] != CellStatus::base_plane && origins[i] != CellStatus::outside) continue;
    if (!cut.colours.empty()) cut.colours[i] = {};
    if (!cut.intensities.empty()) cut.intensities[i] = {};
  }
  coverRim(cut, origins, size);
  return cut;
}

GridColours levelColours(const Surface& surface, Level level) {
  const GridSize size = levelFrame(surface, level).size;
  return levelColours(surface, level,
                      {.left = 0, .right = size.cols - 1, .bottom = 0, .top = size.rows - 1});
}

namespace {

/// Of the measured cells: "98.2 %"
Message ownShare(const OwnCells& cells) {
  return percentWords(static_cast<double>(cells.own) /
                      static_cast<double>(std::max<std::size_t>(cells.measured, 1)));
}

NumberArgument sixDigits(double number) {
  return {.value = number, .digits = 6, .form = NumberArgument::Form::significant};
}

/// @param pixels  of the finest level, alpha last
template <std::size_t Size>
OwnCells ownCells(const DepthMap& map, const std::vector<std::array<std::uint8_t, Size>>& pixels) {
  OwnCells cells;
  for (std::size_t i = 0; i < map.origins.size(); ++i) {
    if (!takesColours(map.origins[i])) continue;
    ++cells.measured;
    cells.own += pixels[i][Size - 1] == kStoredAlpha ? 1 : 0;
  }
  return cells;
}

void sayColours(Surface& surface, const GridColours& finest, const Scan& scan) {
  if (!finest.colours.empty()) {
    surface.messages.push_back(colourWords(ownCells(surface.map, finest.colours)));
  }
  if (!finest.intensities.empty()) {
    surface.messages.push_back(
        intensityWords(ownCells(surface.map, finest.intensities), shownIntensities(scan)));
  }
}

}  // namespace

Message colourWords(const OwnCells& cells) {
  return said<MessageId::scan_has_colours>(ownShare(cells));
}

Message intensityWords(const OwnCells& cells, const IntensityRange& shown) {
  return said<MessageId::scan_has_intensities>(ownShare(cells), sixDigits(shown.low),
                                               sixDigits(shown.high));
}

ColourRule colourRuleOf(const std::string& rule) {
  return rule.ends_with(describe(PointRule::front)) ? ColourRule::winner : ColourRule::layer;
}

void addColours(Surface& surface, const Scan& scan, const Task& task) {
  const DepthRequest request{
      .scan = scan, .view_from_file = surface.view_from_file, .frame = surface.map.frame};
  GridColours finest = gridColours(request, surface.map, colourRuleOf(surface.rule), task);
  sayColours(surface, finest, scan);
  surface.colours = colourLevels(std::move(finest), surface.pyramid, 0, task);
}

void addColours(Surface& surface, GridColours&& finest, const Task& task) {
  surface.colours = colourLevels(std::move(finest), surface.pyramid, 0, task);
  if (surface.colours.empty()) return;
  surface.messages.push_back(said<MessageId::map_has_colours_beside>());
}

double rivalShare(const Surface& surface, const RegionWindow& window, ReliefKind kind,
                  StereoPrint print) {
  if (kind != ReliefKind::natural || !keepsColours(print)) return 0;
  return rivalShare(windowColours(surface, window).colours);
}

std::string rivalryWords(double share) {
  if (share <= kMostRivalShare) return {};
  return std::to_string(static_cast<int>(std::lround(100 * share))) +
         " % of the picture is a strong red or cyan, which one eye sees dark through the glasses. "
         "Grey stereo shows it to both.";
}

bool canShow(const Surface& surface, ReliefKind kind) {
  if (kind != ReliefKind::natural && kind != ReliefKind::intensity) return true;
  const bool natural = kind == ReliefKind::natural;
  if (surface.tiles) return natural ? surface.tiles->hasColours() : surface.tiles->hasIntensities();
  if (surface.colours.empty()) return false;
  const StoredColours& finest = surface.colours.front();
  return natural ? finest.hasColours() : finest.hasIntensities();
}

GridColours finestColours(const Surface& surface) {
  return surface.colours.empty() ? GridColours{} : surface.colours.front().all();
}

void requireColours(const Surface& surface, ReliefKind kind) {
  if (canShow(surface, kind)) return;
  if (kind == ReliefKind::natural) throw failure<MessageId::no_natural_colours>();
  throw failure<MessageId::no_intensities>();
}

}  // namespace relievo
