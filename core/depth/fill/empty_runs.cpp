// SPDX-License-Identifier: BSD-3-Clause
#include "core/depth/fill/empty_runs.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <numeric>
#include <utility>

#include "core/base/failure.h"
#include "core/depth/fill/grid_rows.h"

namespace relievo {

std::uint32_t EmptyRuns::rootOf(std::uint32_t run) {
  while (parents_[run] != run) {
    parents_[run] = parents_[parents_[run]];
    run = parents_[run];
  }
  return run;
}

void EmptyRuns::unite(std::uint32_t a, std::uint32_t b) {
  a = rootOf(a);
  b = rootOf(b);
  if (a != b) parents_[std::max(a, b)] = std::min(a, b);
}

void EmptyRuns::addRows(std::string_view packed) {
  std::vector<std::uint64_t> words(BitRows::wordsPerRow(size_.cols));
  const std::size_t bytes = words.size() * sizeof(std::uint64_t);
  for (std::size_t at = 0; at + bytes <= packed.size(); at += bytes) {
    std::memcpy(words.data(), packed.data() + at, bytes);
    addRow(words);
  }
}

void EmptyRuns::addRow(const std::vector<std::uint64_t>& words) {
  const std::size_t below = row_starts_.size() < 2 ? 0 : row_starts_[row_starts_.size() - 2];
  const std::size_t start = runs_.size();
  std::size_t under = below;
  // The first column from `col` on that is covered or, else, that is empty.
  const auto next = [&](int col, bool covered) {
    auto from = static_cast<std::size_t>(col);
    for (; from < static_cast<std::size_t>(size_.cols); from = (from / 64 + 1) * 64) {
      const std::uint64_t bits = (covered ? words[from / 64] : ~words[from / 64]) >> from % 64;
      if (bits == 0) continue;
      return std::min(static_cast<int>(from) + std::countr_zero(bits), size_.cols);
    }
    return size_.cols;
  };
  for (int col = next(0, false); col < size_.cols; col = next(col, false)) {
    Run run{.first_col = col};
    col = next(col, true);
    run.end_col = col;
    if (runs_.size() >= UINT32_MAX) {
      throw failure<MessageId::map_holes_too_many>();
    }
    const auto number = static_cast<std::uint32_t>(runs_.size());
    runs_.push_back(run);
    parents_.push_back(number);
    empty_cells_ += static_cast<std::size_t>(run.end_col - run.first_col);
    while (under < start && runs_[under].end_col <= run.first_col) ++under;
    for (std::size_t i = under; i < start && runs_[i].first_col < run.end_col; ++i) {
      unite(number, static_cast<std::uint32_t>(i));
    }
  }
  row_starts_.push_back(runs_.size());
}

void EmptyRuns::join() {
  // The root of an area is its first run, so areas are numbered by their first cell.
  for (std::uint32_t i = 0; i < runs_.size(); ++i) {
    runs_[i].area = parents_[i] == i ? areas_++ : runs_[parents_[i]].area;
  }
}

std::span<const EmptyRuns::Run> EmptyRuns::row(int row) const noexcept {
  const std::size_t first = row_starts_[static_cast<std::size_t>(row)];
  const std::size_t end = row_starts_[static_cast<std::size_t>(row) + 1];
  return {runs_.data() + first, end - first};
}

EmptyRuns::Enclosed EmptyRuns::enclosed(const GridFrame& frame) const {
  struct Area {
    bool at_border = false;
    std::size_t cells = 0;
    double sum_col = 0, sum_row = 0;  // Whole numbers, exact.
  };
  std::vector<Area> areas(areas_);
  for (int r = 0; r < size_.rows; ++r) {
    const bool border_row = r == 0 || r == size_.rows - 1;
    for (const Run& run : row(r)) {
      Area& area = areas[run.area];
      const int cells = run.end_col - run.first_col;
      area.at_border |= border_row || run.first_col == 0 || run.end_col == size_.cols;
      area.cells += static_cast<std::size_t>(cells);
      area.sum_col += 0.5 * (run.first_col + run.end_col - 1) * cells;
      area.sum_row += static_cast<double>(r) * cells;
    }
  }
  std::vector<std::uint32_t> order;
  for (std::uint32_t i = 0; i < areas_; ++i) {
    if (!areas[i].at_border) order.push_back(i);
  }
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return areas[a].cells > areas[b].cells;
  });
  Enclosed enclosed;
  enclosed.hole_of_area.assign(areas_, -1);
  for (const std::uint32_t i : order) {
    const auto cells = static_cast<double>(areas[i].cells);
    enclosed.hole_of_area[i] = static_cast<std::ptrdiff_t>(enclosed.holes.size());
    enclosed.holes.push_back(
        {.cells = areas[i].cells,
         .area_mm2 = cells * frame.spacing_mm * frame.spacing_mm,
         .centre_x_mm = frame.first_x_mm + areas[i].sum_col / cells * frame.spacing_mm,
         .centre_y_mm = frame.first_y_mm + areas[i].sum_row / cells * frame.spacing_mm});
  }
  return enclosed;
}

}  // namespace relievo
