// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <compare>
#include <cstddef>

namespace relievo {

/// Node of a grid; row 0 is the lowest y, rows grow with y.
struct Cell {
  int col = 0, row = 0;
  friend bool operator==(Cell, Cell) = default;
};

struct GridSize {
  int cols = 0, rows = 0;
  std::size_t count() const noexcept {
    return static_cast<std::size_t>(cols) * static_cast<std::size_t>(rows);
  }
  std::size_t index(Cell c) const noexcept {
    return static_cast<std::size_t>(c.row) * static_cast<std::size_t>(cols) +
           static_cast<std::size_t>(c.col);
  }
  bool contains(Cell c) const noexcept {
    return c.col >= 0 && c.row >= 0 && c.col < cols && c.row < rows;
  }
  friend bool operator==(GridSize, GridSize) = default;
};

/// Pyramid level; 0 is the finest (the paper's g_0). Its own type, so that it cannot be swapped
/// with a column.
struct Level {
  int value = 0;
  friend auto operator<=>(Level, Level) = default;  // NOLINT(modernize-use-nullptr): false alarm.
};

/// Where the samples of a grid lie: sample (col, row) is at first_x_mm + col * spacing_mm,
/// first_y_mm + row * spacing_mm in the view frame.
struct GridFrame {
  GridSize size;
  double spacing_mm = 0;  ///< Distance of neighbouring samples, the same in x and y.
  double first_x_mm = 0, first_y_mm = 0;

  double xMm(int col) const noexcept { return first_x_mm + col * spacing_mm; }
  double yMm(int row) const noexcept { return first_y_mm + row * spacing_mm; }
  friend bool operator==(const GridFrame&, const GridFrame&) = default;
};

}  // namespace relievo
