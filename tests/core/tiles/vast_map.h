// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <span>
#include <vector>

#include "core/tiles/published/publish.h"
#include "core/tiles/tile_layout.h"

namespace relievo::test {

inline constexpr int kVastSide = 1'000'000;

/// Publishes a map of 10^6 x 10^6 cells of 1 mm of which each level has nine tiles around the
/// middle only; the rest is outside. Levels as of a factor of 2, down to one of 123 cells.
/// @param height  in mm, 0 to `high_mm`
inline void publishVastMap(const std::filesystem::path& folder, double high_mm,
                           const std::function<double(double x_mm, double y_mm)>& height) {
  PublishedMap facts;
  facts.spacing_mm = 1;
  facts.low_mm = 0;
  facts.high_mm = high_mm;
  facts.parts = {TilePart::heights, TilePart::origins};
  facts.view_from_file = ViewFromFile{}.m;
  for (int side = kVastSide; side > 200; side = (side + 1) / 2) {
    facts.levels.push_back({.cols = side, .rows = side});
  }
  facts.levels.push_back({.cols = 123, .rows = 123});
  facts.cells_by_origin[static_cast<std::size_t>(CellStatus::outside)] = 1e12;
  PublishedFolder out(folder, facts);
  const std::vector<std::byte> measured(bytesOf(TilePart::origins), std::byte{0});
  for (int level = 0; level < static_cast<int>(facts.levels.size()); ++level) {
    const GridSize size = facts.levels[static_cast<std::size_t>(level)];
    const double spacing_mm = 1 << level;
    const int across = TileLayout{size}.across(), middle = size.cols / 2 / kTileSide;
    const auto tileOf = [&](int tile) -> std::vector<std::vector<std::byte>> {
      const int x = tile % across, y = tile / across;
      if (std::max(std::abs(x - middle), std::abs(y - middle)) > 1) return {};
      std::vector<float> heights;
      for (int line = 0; line < kTileSide; ++line) {
        for (int col = 0; col < kTileSide; ++col) {
          const double row = size.rows - 1 - (y * kTileSide + line);
          heights.push_back(
              static_cast<float>(height((x * kTileSide + col) * spacing_mm, row * spacing_mm)));
        }
      }
      const auto bytes = std::as_bytes(std::span(heights));
      return {{bytes.begin(), bytes.end()}, measured};
    };
    for (int pack = 0; pack < packsOf(size); ++pack) {
      const std::vector<int> tiles = tilesOfPack(size, pack);
      const bool has_any = std::any_of(tiles.begin(), tiles.end(), [&](int tile) {
        return std::max(std::abs(tile % across - middle), std::abs(tile / across - middle)) <= 1;
      });
      if (has_any) out.add(level, pack, tileOf);
    }
  }
  out.finish();
}

}  // namespace relievo::test
