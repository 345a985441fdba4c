// SPDX-License-Identifier: BSD-3-Clause
#include "core/tiles/row_store.h"

#include <algorithm>
#include <bit>

namespace relievo {

template <class Value>
RowStoreOf<Value>::RowStoreOf(GridSize size, std::size_t memory_bytes,
                              const std::filesystem::path& spill_folder)
    : size_(size), spill_(spill_folder) {
  if (size.count() * sizeof(Value) <= memory_bytes) values_.resize(size.count());
}

template <class Value>
void RowStoreOf<Value>::write(int first_row, int rows, const Value* values) {
  const std::size_t start = size_.index({.col = 0, .row = first_row});
  const std::size_t count = static_cast<std::size_t>(rows) * static_cast<std::size_t>(size_.cols);
  if (values_.empty()) {
    spill_.write(start * sizeof(Value), std::as_bytes(std::span(values, count)));
  } else {
    std::copy_n(values, count, values_.data() + start);
  }
}

template <class Value>
void RowStoreOf<Value>::read(int first_row, int rows, Value* out) const {
  const std::size_t start = size_.index({.col = 0, .row = first_row});
  const std::size_t count = static_cast<std::size_t>(rows) * static_cast<std::size_t>(size_.cols);
  if (values_.empty()) {
    spill_.read(start * sizeof(Value), std::as_writable_bytes(std::span(out, count)));
  } else {
    std::copy_n(values_.data() + start, count, out);
  }
}

template class RowStoreOf<float>;
template class RowStoreOf<Pixel<3>>;
template class RowStoreOf<Pixel<1>>;

BitRows::BitRows(GridSize size)
    : size_(size),
      words_per_row_((static_cast<std::size_t>(size.cols) + 63) / 64),
      words_(words_per_row_ * static_cast<std::size_t>(size.rows)) {}

std::size_t BitRows::count() const noexcept {
  std::size_t ones = 0;
  for (const std::uint64_t w : words_) ones += static_cast<std::size_t>(std::popcount(w));
  return ones;
}

void BitRows::setRows(int first_row, const std::vector<std::uint8_t>& mask) noexcept {
  Cell cell{.col = 0, .row = first_row};
  for (const std::uint8_t value : mask) {
    if (value != 0) set(cell);
    if (++cell.col == size_.cols) cell = {.col = 0, .row = cell.row + 1};
  }
}

std::vector<std::uint8_t> BitRows::bytes(int first_row, int rows) const {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(static_cast<std::size_t>(rows) * static_cast<std::size_t>(size_.cols));
  for (int row = first_row; row < first_row + rows; ++row) {
    const std::uint64_t* words = &words_[word({.col = 0, .row = row})];
    for (int col = 0; col < size_.cols; ++col) {
      const auto c = static_cast<unsigned>(col);
      bytes.push_back(static_cast<std::uint8_t>((words[c / 64U] >> (c % 64U)) & 1U));
    }
  }
  return bytes;
}

}  // namespace relievo
