// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/grid.h"
#include "core/base/task.h"
#include "core/depth/colours/cell_colours.h"
#include "core/depth/colours/colour_fill.h"
#include "core/tiles/row_store.h"
#include "core/tiles/tile_store.h"

namespace relievo {

struct BandColourOptions {
  ColourRule rule = ColourRule::layer;
  bool colours = false, intensities = false;  ///< Which the points have.
  std::filesystem::path spill_folder = ".";
};

/// gridColours of core/depth for maps that do not fit into memory: the same bytes. Gets the rows of
/// the finished map as they are made, and gives those of its colours when the last is there.
class BandColours {
 public:
  /// @param store  the map's points as scatterValues puts them there; must stay
  /// @param counts  what scatterValues returned
  BandColours(const ValueStore& store, const GridFrame& frame, const IntensityCounts& counts,
              const BandColourOptions& options);
  ~BandColours();
  BandColours(const BandColours&) = delete;
  BandColours& operator=(const BandColours&) = delete;

  /// The map's next row, lowest first, as in DepthMap. [owner] @throw WriteError, Cancelled
  void add(const float* heights_mm, const CellStatus* origins, const Task& task);

  /// After the last row. [owner] @throw Cancelled
  void close(const Task& task);
  /// Has any cell one? False where all points lie off the map's surface.
  bool hasColours() const noexcept;
  bool hasIntensities() const noexcept;
  /// Cells that points gave their height, and how many of them have one from a point.
  std::size_t measuredCells() const noexcept { return measured_; }
  std::size_t colouredCells() const noexcept;
  std::size_t intensityCells() const noexcept;
  IntensityRange shownIntensities(const std::optional<IntensityRange>& stored) const noexcept {
    return stretch_.shown(stored);
  }

  /// Gives the rows, lowest first; null for what there is not. [owner]
  /// @throw WriteError, Cancelled and what `take` throws
  using TakeRow = std::function<void(const Rgba* colours, const GreyAlpha* intensities)>;
  void write(const TakeRow& take, const Task& task) const;

  /// Bytes that it takes beside the store, about.
  static std::size_t memoryBytes(GridSize map, int threads) noexcept;

 private:
  template <std::size_t Channels>
  struct Kind;
  void makeBand(const Task& task);

  const ValueStore& store_;
  GridFrame frame_;
  BandColourOptions options_;
  IntensityStretch stretch_;
  std::size_t measured_ = 0;
  int first_row_ = 0;  ///< Of the rows that are collected.
  std::vector<float> heights_mm_;
  std::vector<CellStatus> origins_;
  std::unique_ptr<Kind<3>> colours_;
  std::unique_ptr<Kind<1>> intensities_;
};

}  // namespace relievo
