// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/grid.h"

namespace relievo {

/// Rows first_row ... first_row + rows - 1 of a grid of floats, row by row, lowest first; `out` has
/// room for them. Whoever gives one says on how many threads it may be called.
using RowsOf = std::function<void(int first_row, int rows, float* out)>;

/// Where a grid of floats comes from: rows that are read, and the whole of it if it is in memory.
struct GridRows {
  RowsOf read;
  const float* all = nullptr;  ///< Row by row, lowest first; null: not in memory.

  GridRows() = default;
  GridRows(RowsOf rows) : read(std::move(rows)) {}  // NOLINT(google-explicit-constructor)
  /// @param values  must stay where they are; empty: no such grid
  static GridRows inMemory(std::span<const float> values, GridSize size);
  explicit operator bool() const noexcept { return static_cast<bool>(read); }
  /// The rows where they are, or read into `buffer`.
  const float* rows(int first_row, int count, GridSize size, std::vector<float>& buffer) const;
};

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
  /// Of the square with this cell at its lower left.
  int countInSquare(Cell lowest, int side) const noexcept;
  /// Sets the cells of whole rows that are 1 in `mask`; an empty mask sets none.
  void setRows(int first_row, std::span<const std::uint8_t> mask) noexcept;
  /// Sets the cells of whole rows whose bit is set. @param packed  as packedRows gives it
  void setPacked(int first_row, std::string_view packed) noexcept;
  /// Clears those of `cells`, of a grid of the same size.
  void clear(const BitRows& cells) noexcept;
  /// One byte per cell, 0 or 1, of some rows.
  std::vector<std::uint8_t> bytes(int first_row, int rows) const;

  /// Words that a row takes; column c is bit c % 64 of word c / 64, the rest are 0.
  static std::size_t wordsPerRow(int cols) noexcept {
    return (static_cast<std::size_t>(cols) + 63) / 64;
  }

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

/// Whole rows of a mask as the words of BitRows, to be told to others.
std::string packedRows(std::span<const std::uint8_t> mask, int cols);
std::size_t onesIn(std::string_view packed) noexcept;

}  // namespace relievo
