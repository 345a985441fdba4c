// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <vector>

#include "core/base/grid.h"
#include "core/depth/colours/colour_fill.h"
#include "core/tiles/spill_file.h"

namespace relievo {

/// Rows first_row ... first_row + rows - 1 of a grid of floats, row by row, lowest first; `out` has
/// room for them. Whoever gives one says on how many threads it may be called.
using RowsOf = std::function<void(int first_row, int rows, float* out)>;

/// A grid by rows: in memory if it fits into what is allowed, else in a spill file.
template <class Value>
class RowStoreOf {
 public:
  RowStoreOf(GridSize size, std::size_t memory_bytes, const std::filesystem::path& spill_folder);

  /// [owner] @throw WriteError
  void write(int first_row, int rows, const Value* values);
  /// Rows written before. [any thread, while none writes] @throw WriteError
  void read(int first_row, int rows, Value* out) const;

 private:
  GridSize size_;
  std::vector<Value> values_;  ///< Empty if spilled.
  SpillFile spill_;
};

using RowStore = RowStoreOf<float>;
extern template class RowStoreOf<float>;
extern template class RowStoreOf<Pixel<3>>;
extern template class RowStoreOf<Pixel<1>>;

/// One bit per cell of a grid: a 32nd of its heights, so that questions about the whole mask (how
/// wide the gaps are, what is enclosed) can be asked of maps that do not fit into memory.
class BitRows {
 public:
  explicit BitRows(GridSize size);

  GridSize size() const noexcept { return size_; }
  void set(Cell cell) noexcept { words_[word(cell)] |= bit(cell); }
  void clear(Cell cell) noexcept { words_[word(cell)] &= ~bit(cell); }
  bool at(Cell cell) const noexcept { return (words_[word(cell)] & bit(cell)) != 0; }
  std::size_t count() const noexcept;
  /// Sets the cells of whole rows that are 1 in `mask`; an empty mask sets none.
  void setRows(int first_row, const std::vector<std::uint8_t>& mask) noexcept;
  /// One byte per cell, 0 or 1, of some rows.
  std::vector<std::uint8_t> bytes(int first_row, int rows) const;

 private:
  std::size_t word(Cell c) const noexcept {
    return static_cast<std::size_t>(c.row) * words_per_row_ + static_cast<std::size_t>(c.col) / 64;
  }
  static std::uint64_t bit(Cell c) noexcept {
    return std::uint64_t{1} << (static_cast<unsigned>(c.col) % 64U);
  }

  GridSize size_;
  std::size_t words_per_row_ = 0;
  std::vector<std::uint64_t> words_;
};

}  // namespace relievo
