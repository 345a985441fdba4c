// SPDX-License-Identifier: BSD-3-Clause
#include "core/depth/fill/plates.h"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <utility>

#include "core/base/bands.h"
#include "core/base/plain_bytes.h"

namespace relievo {

Plates::Plates(const EmptyRuns& runs, EmptyRuns::Enclosed& enclosed, GridSize size)
    : runs_(&runs), enclosed_(&enclosed), size_(size), plate_of_hole_(enclosed.holes.size(), -1) {
  for (std::size_t hole = 0; hole < enclosed.holes.size(); ++hole) {
    Hole& one = enclosed.holes[hole];
    one.filled = one.filled && one.cells <= kMostMembraneCells;
    if (!one.filled) continue;
    plate_of_hole_[hole] = static_cast<std::ptrdiff_t>(plates_.size());
    plates_.push_back({.hole = hole, .places = {}, .rim = {}, .z_mm = {}});
  }
  constexpr std::size_t kBytesOfBlocks = 64;  // Of the system, for what a plate holds.
  bytes_ = plate_of_hole_.size() * sizeof(plate_of_hole_[0]) +
           plates_.size() * (sizeof(Plate) + kBytesOfBlocks);
  if (plates_.empty()) return;
  std::vector<std::size_t> cells(plates_.size());
  for (int row = 0; row < size.rows; ++row) {
    for (const EmptyRuns::Run& run : runs.row(row)) {
      const std::ptrdiff_t hole = enclosed.hole_of_area[run.area];
      const std::ptrdiff_t plate = hole < 0 ? -1 : plate_of_hole_[static_cast<std::size_t>(hole)];
      if (plate < 0) continue;
      std::size_t& start = cells[static_cast<std::size_t>(plate)];
      plates_[static_cast<std::size_t>(plate)].places.push_back(
          {.row = row, .first_col = run.first_col, .end_col = run.end_col, .start = start});
      const auto count = static_cast<std::size_t>(run.end_col - run.first_col);
      start += count;
      bytes_ += sizeof(Place) + sizeof(float) * count;
    }
  }
}

std::vector<Plates::RimCell> Plates::rimCells(int first, int end) const {
  constexpr std::uint32_t kFree = 0xffffffff;
  constexpr std::uint32_t kEmpty = 0xfffffffe;  // Else the hole that took the cell last.
  std::vector<RimCell> found;
  std::vector<std::uint32_t> state;
  const auto place = [&](Cell cell) {
    return size_.index({.col = cell.col, .row = cell.row - first});
  };
  const auto begin = [&] {
    state.assign(size_.index({.col = 0, .row = end - first}), kFree);
    for (int row = first; row < end; ++row) {
      for (const EmptyRuns::Run& run : runs_->row(row)) {
        const auto start =
            state.begin() + static_cast<std::ptrdiff_t>(place({.col = 0, .row = row}));
        std::fill(start + run.first_col, start + run.end_col, kEmpty);
      }
    }
  };
  const auto take = [&](std::uint32_t hole, Cell cell) {
    if (cell.row < first || cell.row >= end || !size_.contains(cell)) return;
    std::uint32_t& was = state[place(cell)];
    if (was == kEmpty || was == hole) return;
    was = hole;
    found.push_back({.cell = size_.index(cell), .hole = hole});
  };
  for (int row = std::max(0, first - kRimRows); row < std::min(size_.rows, end + kRimRows); ++row) {
    for (const EmptyRuns::Run& run : runs_->row(row)) {
      const std::ptrdiff_t hole = enclosed_->hole_of_area[run.area];
      if (hole < 0 || plate_of_hole_[static_cast<std::size_t>(hole)] < 0) continue;
      if (state.empty()) begin();
      for (int col = run.first_col; col < run.end_col; ++col) {
        for (const Cell reach : kRimReach) {
          take(static_cast<std::uint32_t>(hole), {.col = col + reach.col, .row = row + reach.row});
        }
      }
    }
  }
  return found;
}

void Plates::add(std::string_view rim_cells) {
  std::vector<RimCell> cells;
  PlainBytes(rim_cells).take(cells, rim_cells.size() / sizeof(RimCell));
  constexpr std::size_t kBytesInRim = 48;  // A node and its share of the table.
  bytes_ += kBytesInRim * cells.size();
  for (const RimCell& one : cells) {
    const std::ptrdiff_t plate = plate_of_hole_[one.hole];
    plates_[static_cast<std::size_t>(plate)].rim.emplace(one.cell, one.z_mm);
  }
}

std::vector<float> Plates::solved(const Plate& plate, const Task& task) const {
  std::vector<std::size_t> cells;
  for (const Place& place : plate.places) {
    for (int col = place.first_col; col < place.end_col; ++col) {
      cells.push_back(size_.index({.col = col, .row = place.row}));
    }
  }
  return membraneOver(cells, plate.rim, size_, task);
}

void Plates::solve(Exchange& processes, int threads, const Task& task) {
  // The largest come first: whoever is free takes one, and processes take them in turn.
  const auto ranks = static_cast<std::size_t>(processes.ranks());
  const auto mine = [&](std::size_t number) -> Plate* {
    const std::size_t at = number * ranks + static_cast<std::size_t>(processes.rank());
    return at < plates_.size() ? &plates_[at] : nullptr;
  };
  std::atomic<std::size_t> next = 0;
  std::mutex large_ones;  // One at a time, for their memory.
  parallelFor(threads, threads, [&](int first, int) {
    for (std::size_t number = next++; Plate* const plate = mine(number); number = next++) {
      if (first == 0) {  // On the thread that called.
        task.report("Filling holes", 0.5 + 0.5 * static_cast<double>(number * ranks) /
                                               static_cast<double>(plates_.size()));
      }
      constexpr std::size_t kLarge = 20'000;
      std::unique_lock alone(large_ones, std::defer_lock);
      if (enclosed_->holes[plate->hole].cells > kLarge) alone.lock();
      plate->z_mm = solved(*plate, task);
      plate->rim = {};
    }
  });
  task.check();
  if (!processes.isAlone()) tellOthers(processes);
  for (const Plate& plate : plates_) {
    enclosed_->holes[plate.hole].filled = !plate.z_mm.empty();
  }
}

void Plates::tellOthers(Exchange& processes) {
  const auto ranks = static_cast<std::size_t>(processes.ranks());
  std::string mine;
  for (auto at = static_cast<std::size_t>(processes.rank()); at < plates_.size(); at += ranks) {
    const std::uint64_t count = plates_[at].z_mm.size();
    mine.append(plainBytes(count)).append(plainBytes(plates_[at].z_mm));
  }
  const std::vector<std::string> told = processes.share(mine);
  std::vector<PlainBytes> bytes(told.begin(), told.end());
  for (std::size_t at = 0; at < plates_.size(); ++at) {
    std::uint64_t count = 0;
    bytes[at % ranks].take(count);
    bytes[at % ranks].take(plates_[at].z_mm, count);
    plates_[at].rim = {};
  }
}

void Plates::take(int first_row, int rows, float* depths) const {
  if (plates_.empty()) return;
  for (int row = first_row; row < first_row + rows; ++row) {
    for (const EmptyRuns::Run& run : runs_->row(row)) {
      const std::ptrdiff_t hole = enclosed_->hole_of_area[run.area];
      const std::ptrdiff_t at = hole < 0 ? -1 : plate_of_hole_[static_cast<std::size_t>(hole)];
      if (at < 0 || plates_[static_cast<std::size_t>(at)].z_mm.empty()) continue;
      const Plate& plate = plates_[static_cast<std::size_t>(at)];
      const auto place =
          std::lower_bound(plate.places.begin(), plate.places.end(), std::pair(row, run.first_col),
                           [](const Place& one, const std::pair<int, int>& wanted) {
                             return std::pair(one.row, one.first_col) < wanted;
                           });
      const auto from = plate.z_mm.begin() + static_cast<std::ptrdiff_t>(place->start);
      std::copy(from, from + (run.end_col - run.first_col),
                depths + size_.index({.col = run.first_col, .row = row - first_row}));
    }
  }
}

}  // namespace relievo
