// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <vector>

#include "core/depth/depth_map.h"
#include "core/depth/quality.h"

namespace relievo {

/// What is known of how far the heights of a map may be off, beside what their neighbours tell.
struct HeightErrors {
  double step_mm = 0;                   ///< Between heights that could be stored; 0: not known.
  const QualityMap* quality = nullptr;  ///< Of the cells, or null. Must outlive this.
  bool of_one_point = false;  ///< A height is one of its cell's points, not a mean of them.
};

/// A rectangle of cells of a map, asked for by their places in the whole map.
class MapPart {
 public:
  /// All cells of a map, which must outlive this.
  explicit MapPart(const DepthMap& map, const HeightErrors& errors = {});
  /// @param frame  of the whole map  @param first  of `cells`, its lower left one
  MapPart(const GridFrame& frame, Cell first, DepthMap cells);
  MapPart(MapPart&&) = default;
  MapPart& operator=(MapPart&&) = default;
  MapPart(const MapPart&) = delete;
  MapPart& operator=(const MapPart&) = delete;
  ~MapPart() = default;

  const GridFrame& frame() const noexcept { return frame_; }  ///< Of the whole map.
  // @pre within the rectangle
  float heightMm(Cell c) const noexcept { return heights_mm_[index(c)]; }
  CellStatus origin(Cell c) const noexcept { return origins_[index(c)]; }
  /// How far a cell's height may be off: half a step of the heights, never less than single
  /// precision rounds lengths of the map's size, and twice the standard error of the mean of the
  /// cell's points (of one point: twice their spread). Above 0.
  double heightErrorMm(Cell c) const noexcept;

 private:
  std::size_t index(Cell c) const noexcept {
    return cells_.index({.col = c.col - first_.col, .row = c.row - first_.row});
  }

  GridFrame frame_;
  Cell first_;
  GridSize cells_;
  DepthMap own_;  ///< Empty for a part of a map in memory.
  HeightErrors errors_;
  const float* heights_mm_;
  const CellStatus* origins_;
};

/// The cells of a depth map that need not be in memory: they are read part by part. What is
/// measured takes one of these and gives the same for both, bit for bit.
class MapCells {
 public:
  using ReadPart = std::function<MapPart(Cell first, GridSize size)>;

  /// Of a map in memory, which must outlive this. Not explicit: it is the map.
  MapCells(const DepthMap& map, const HeightErrors& errors = {});
  /// @param read  gives at least the cells of a rectangle that lies within the map
  MapCells(const GridFrame& frame, ReadPart read);

  const GridFrame& frame() const noexcept { return frame_; }
  /// At least the cells of a rectangle within the map. @throw what the reader throws
  MapPart part(Cell first, GridSize size) const { return read_(first, size); }

 private:
  GridFrame frame_;
  ReadPart read_;
};

}  // namespace relievo
