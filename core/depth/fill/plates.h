// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/exchange.h"
#include "core/base/grid.h"
#include "core/base/task.h"
#include "core/depth/fill/empty_runs.h"
#include "core/depth/fill/membrane.h"

namespace relievo {

/// Membranes over the holes of a map that comes by bands: first every band gives its part of their
/// rims, then each membrane is solved, and bands take their rows of it.
class Plates {
 public:
  Plates() = default;
  /// For the holes that are to be filled; one that is too large is no longer.
  /// @param runs, enclosed  must stay
  Plates(const EmptyRuns& runs, EmptyRuns::Enclosed& enclosed, GridSize size);

  bool empty() const noexcept { return plates_.empty(); }
  /// What they keep until they are solved, about.
  std::size_t bytes() const noexcept { return bytes_; }

  /// A cell beside a hole.
  struct RimCell {
    std::uint64_t cell = 0;
    std::uint32_t hole = 0;
    float z_mm = 0;
  };
  /// Cells of rows first ... end - 1 that are asked for, without heights. [any thread]
  std::vector<RimCell> rimCells(int first, int end) const;
  /// [owner]
  void add(std::string_view rim_cells);

  /// When all rims are there; a hole whose rim determines no membrane is not filled. Several
  /// processes solve some each. Large ones are solved one at a time. [owner]
  /// @throw Cancelled, OtherProcessStopped
  void solve(Exchange& processes, int threads, const Task& task);

  /// Replaces the cells of rows first_row ... that a membrane covers. [any thread]
  /// @param depths  of whole rows
  void take(int first_row, int rows, float* depths) const;

 private:
  struct Place {
    int row = 0, first_col = 0, end_col = 0;
    std::size_t start = 0;  ///< Of the plate's cells.
  };
  struct Plate {
    std::size_t hole = 0;
    std::vector<Place> places;  ///< By rows, then columns.
    Rim rim;
    std::vector<float> z_mm;
  };
  std::vector<float> solved(const Plate& plate, const Task& task) const;
  void tellOthers(Exchange& processes);

  const EmptyRuns* runs_ = nullptr;
  EmptyRuns::Enclosed* enclosed_ = nullptr;
  GridSize size_;
  std::vector<Plate> plates_;
  std::vector<std::ptrdiff_t> plate_of_hole_;
  std::size_t bytes_ = 0;
};

}  // namespace relievo
