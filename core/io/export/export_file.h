// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Only for the .cpp files of core/io that write exports.
#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/file/atomic_file.h"
#include "core/io/export/export_grid.h"

namespace relievo {

static_assert(std::endian::native == std::endian::little, "binary exports are written as stored");

/// Buffered text and bytes into a file that replaces the old one when all went well.
class ExportFile {
 public:
  explicit ExportFile(const OutputFile& file) : file_(file) {}

  ExportFile& operator<<(std::string_view text) {
    add(text.data(), text.size());
    return *this;
  }
  /// Shortest digits that read back as the same number.
  template <class Number>
  void number(Number value) {
    std::array<char, 32> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
    add(digits.data(), static_cast<std::size_t>(end - digits.data()));
  }
  template <class T>
  void bytes(const T& value) {
    add(reinterpret_cast<const char*>(&value), sizeof(T));
  }
  template <class T>
  void array(const std::vector<T>& values) {
    add(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
  }
  void commit() {
    flush();
    file_.commit();
  }

 private:
  static constexpr std::size_t kAtOnce = std::size_t{1} << 18U;

  void add(const char* bytes, std::size_t count) {
    waiting_.append(bytes, count);
    if (waiting_.size() >= kAtOnce) flush();
  }
  void flush() {
    file_.write(waiting_);
    waiting_.clear();
  }

  AtomicFile file_;
  std::string waiting_;
};

inline double xOf(const ExportGrid& grid, int col) {
  return grid.first_x + col * grid.spacing;
}
inline double yOf(const ExportGrid& grid, int row) {
  return grid.first_y + row * grid.spacing;
}

/// Of the cells with a height their number among these, else -1.
inline std::vector<std::int32_t> vertexNumbers(const ExportGrid& grid, std::uint32_t& count) {
  std::vector<std::int32_t> numbers(grid.heights.size(), -1);
  count = 0;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (grid.holds(i)) numbers[i] = static_cast<std::int32_t>(count++);
  }
  return numbers;
}

using Triangle = std::array<std::int32_t, 3>;

/// Two for every four neighbours that all have a height.
inline std::vector<Triangle> trianglesBetween(const ExportGrid& grid,
                                              const std::vector<std::int32_t>& numbers) {
  std::vector<Triangle> triangles;
  for (int row = 0; row + 1 < grid.size.rows; ++row) {
    for (int col = 0; col + 1 < grid.size.cols; ++col) {
      const std::int32_t a = numbers[grid.size.index({col, row})];
      const std::int32_t b = numbers[grid.size.index({col + 1, row})];
      const std::int32_t c = numbers[grid.size.index({col + 1, row + 1})];
      const std::int32_t d = numbers[grid.size.index({col, row + 1})];
      if (std::min({a, b, c, d}) < 0) continue;
      triangles.push_back({a, b, c});
      triangles.push_back({a, c, d});
    }
  }
  return triangles;
}

}  // namespace relievo
