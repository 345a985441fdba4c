// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "core/base/grid.h"
#include "core/depth/colours/colour_fill.h"
#include "core/depth/fill/grid_rows.h"
#include "core/tiles/spill_file.h"

namespace relievo {

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

}  // namespace relievo
