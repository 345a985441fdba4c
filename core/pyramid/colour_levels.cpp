// SPDX-License-Identifier: BSD-3-Clause
#include "core/pyramid/colour_levels.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "core/base/bands.h"
#include "core/pyramid/light_rows.h"
#include "core/pyramid/row_reducer.h"

namespace relievo {
namespace {

/// Rows of a level as light. Keeps those that one coarser row is made of.
template <std::size_t Size>
class KeptRows {
 public:
  KeptRows(const std::vector<std::array<std::uint8_t, Size>>& pixels, GridSize size,
           const LightOfRows<Size>& light, std::size_t kept)
      : pixels_(pixels),
        size_(size),
        light_(light),
        rows_(kept, -1),
        planes_(kept * Size * static_cast<std::size_t>(size.cols)) {}

  const float* at(int row, std::size_t plane) {
    const std::size_t slot = static_cast<std::size_t>(row) % rows_.size();
    const auto cols = static_cast<std::size_t>(size_.cols);
    float* const planes = &planes_[slot * Size * cols];
    if (rows_[slot] != row) {
      rows_[slot] = row;
      light_.split(&pixels_[size_.index({.col = 0, .row = row})], cols, planes);
    }
    return planes + plane * cols;
  }

 private:
  const std::vector<std::array<std::uint8_t, Size>>& pixels_;
  GridSize size_;
  const LightOfRows<Size>& light_;
  std::vector<int> rows_;
  std::vector<float> planes_;
};

template <std::size_t Size>
std::vector<std::array<std::uint8_t, Size>> coarser(
    const std::vector<std::array<std::uint8_t, Size>>& fine, GridSize size, double factor,
    bool finest, int threads, const Task& task) {
  if (fine.empty()) return {};
  const LightOfRows<Size> rows_light(transferOf<Size>(), finest);
  const GridSize out_size = RowReducer(size, factor).coarseSize();
  std::vector<std::array<std::uint8_t, Size>> out(out_size.count());
  parallelFor(out_size.rows, threadsFor(size.count(), threads), [&](int first, int end) {
    RowReducer reducer(size, factor);
    KeptRows<Size> kept(fine, size, rows_light, static_cast<std::size_t>(reducer.mostRows()));
    const auto cols = static_cast<std::size_t>(out_size.cols);
    std::array<std::vector<float>, Size> sums;
    std::array<const float*, Size> planes{};
    for (std::size_t plane = 0; plane < Size; ++plane) {
      sums[plane].resize(cols);
      planes[plane] = sums[plane].data();
    }
    for (int row = first; row < end; ++row) {
      if (row % 16 == 0) task.check();
      for (std::size_t plane = 0; plane < Size; ++plane) {
        reducer.reduce(
            row, [&](int fine_row) { return kept.at(fine_row, plane); }, sums[plane].data());
      }
      rows_light.join(planes, cols, &out[out_size.index({.col = 0, .row = row})]);
    }
  });
  return out;
}

}  // namespace

std::vector<StoredColours> colourLevels(GridColours&& finest, const Pyramid& pyramid, int threads,
                                        const Task& task) {
  std::vector<StoredColours> levels;
  if (finest.empty()) return levels;
  GridColours fine = std::move(finest);
  makeStorable(fine);  // What is kept is what coarser levels are made of.
  levels.emplace_back(fine);
  for (std::size_t level = 1; level < pyramid.levels.size(); ++level) {
    const GridSize size = pyramid.levels[level - 1].frame.size;
    GridColours next{
        .colours = coarser(fine.colours, size, pyramid.factor, level == 1, threads, task),
        .intensities = coarser(fine.intensities, size, pyramid.factor, level == 1, threads, task)};
    makeStorable(next);
    levels.emplace_back(next);
    fine = std::move(next);
  }
  return levels;
}

}  // namespace relievo
