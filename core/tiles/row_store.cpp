// SPDX-License-Identifier: BSD-3-Clause
#include "core/tiles/row_store.h"

#include <algorithm>
#include <span>

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

}  // namespace relievo
