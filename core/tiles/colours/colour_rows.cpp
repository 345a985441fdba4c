// SPDX-License-Identifier: BSD-3-Clause
#include "core/tiles/colours/colour_rows.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/depth/colours/stored_colours.h"
#include "core/pyramid/light_rows.h"
#include "core/pyramid/row_reducer.h"

namespace relievo {
namespace {

/// The newest rows of a level as light, and the coarser row that they make.
template <std::size_t Size>
class LightRing {
 public:
  using Pixel = std::array<std::uint8_t, Size>;

  LightRing(int rows, int fine_cols, int coarse_cols, bool finest)
      : rows_(rows),
        cols_(static_cast<std::size_t>(fine_cols)),
        light_(transferOf<Size>(), finest),
        out_(static_cast<std::size_t>(coarse_cols)) {
    planes_.resize(static_cast<std::size_t>(rows) * cols_ * Size);
    for (std::vector<float>& sums : sums_) sums.resize(out_.size());
  }

  void put(int row, const Pixel* pixels) { light_.split(pixels, cols_, at(row)); }

  Pixel* reduce(RowReducer& reducer, int coarse_row) {
    std::array<const float*, Size> planes{};
    for (std::size_t plane = 0; plane < Size; ++plane) {
      reducer.reduce(
          coarse_row, [&](int row) { return at(row) + plane * cols_; }, sums_[plane].data());
      planes[plane] = sums_[plane].data();
    }
    light_.join(planes, out_.size(), out_.data());
    return out_.data();
  }

 private:
  float* at(int row) { return &planes_[static_cast<std::size_t>(row % rows_) * cols_ * Size]; }

  int rows_;
  std::size_t cols_;
  LightOfRows<Size> light_;
  std::vector<float> planes_;
  std::array<std::vector<float>, Size> sums_;
  std::vector<Pixel> out_;
};

}  // namespace

struct ColourPyramidRows::Step {
  Step(GridSize fine, double factor, bool finest)
      : reducer(fine, factor),
        colours(reducer.mostRows(), fine.cols, reducer.coarseSize().cols, finest),
        intensities(reducer.mostRows(), fine.cols, reducer.coarseSize().cols, finest) {}

  RowReducer reducer;
  LightRing<4> colours;
  LightRing<2> intensities;
};

ColourPyramidRows::ColourPyramidRows(std::vector<GridFrame> frames, double factor, TakeRow take)
    : frames_(std::move(frames)), take_(std::move(take)), next_row_(frames_.size()) {
  for (std::size_t level = 0; level + 1 < frames_.size(); ++level) {
    steps_.push_back(std::make_unique<Step>(frames_[level].size, factor, level == 0));
  }
}

ColourPyramidRows::~ColourPyramidRows() = default;

void ColourPyramidRows::add(const Rgba* colours, const GreyAlpha* intensities) {
  give(0, colours, intensities);
}

void ColourPyramidRows::give(std::size_t level, const Rgba* colours, const GreyAlpha* intensities) {
  const auto cols = static_cast<std::size_t>(frames_[level].size.cols);
  GridColours kept;  // As they are kept is how they are averaged further.
  if (colours != nullptr && intensities != nullptr) {
    kept.colours.assign(colours, colours + cols);
    kept.intensities.assign(intensities, intensities + cols);
    makeStorable(kept);
    colours = kept.colours.data();
    intensities = kept.intensities.data();
  }
  const int row = next_row_[level]++;
  take_({.level = {static_cast<int>(level)},
         .row = row,
         .colours = colours,
         .intensities = intensities});
  if (level == steps_.size()) return;
  Step& step = *steps_[level];
  if (colours != nullptr) step.colours.put(row, colours);
  if (intensities != nullptr) step.intensities.put(row, intensities);
  const int coarse_rows = step.reducer.coarseSize().rows;
  while (next_row_[level + 1] < coarse_rows &&
         step.reducer.rowsFor(next_row_[level + 1]).end <= row + 1) {
    const int coarse_row = next_row_[level + 1];
    give(level + 1, colours != nullptr ? step.colours.reduce(step.reducer, coarse_row) : nullptr,
         intensities != nullptr ? step.intensities.reduce(step.reducer, coarse_row) : nullptr);
  }
}

}  // namespace relievo
