// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace relievo::samples {

/// A made scan: points as a scanner would deliver them. Coordinates in the unit named.
struct Cloud {
  std::string unit;               ///< "mm" or "m"; goes into the header as `comment unit mm`.
  bool double_precision = false;  ///< Store doubles; needed where offsets are large.
  std::vector<std::array<double, 3>> points;
};

/// The true surface a cloud was taken from, at the samples of a square grid. Same coordinates and
/// unit as the cloud. Sample (col, row) lies at first_x + col * spacing, first_y + row * spacing.
struct Reference {
  int cols = 0, rows = 0;
  double spacing = 0, first_x = 0, first_y = 0;
  std::vector<float> z;  ///< Row-major, row 0 at the lowest y; NaN where there is no surface.

  double x(int col) const noexcept { return first_x + col * spacing; }
  double y(int row) const noexcept { return first_y + row * spacing; }
};

/// Fills a reference from a function z(x, y).
template <class Function>
Reference evaluate(Reference grid, Function&& z) {
  grid.z.clear();
  grid.z.reserve(static_cast<std::size_t>(grid.cols) * static_cast<std::size_t>(grid.rows));
  for (int row = 0; row < grid.rows; ++row) {
    for (int col = 0; col < grid.cols; ++col) {
      grid.z.push_back(static_cast<float>(z(grid.x(col), grid.y(row))));
    }
  }
  return grid;
}

/// Writes through a temporary name, so that an interrupted run leaves no half file.
/// @throw std::runtime_error  cannot write
void writeFile(const std::filesystem::path& file, const std::string& bytes);

}  // namespace relievo::samples
