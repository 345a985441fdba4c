// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <unistd.h>

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "core/base/grid.h"
#include "core/depth/depth_request.h"
#include "core/tiles/points/point_source.h"
#include "core/tiles/row_store.h"

namespace relievo::test {

/// A folder of its own that goes with the object.
class TileFolder {
 public:
  TileFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "relievo-tiles-XXXXXX").string();
    path_ = ::mkdtemp(name.data());
  }
  ~TileFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TileFolder(const TileFolder&) = delete;
  TileFolder& operator=(const TileFolder&) = delete;
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  const std::filesystem::path& path() const noexcept { return path_; }

 private:
  std::filesystem::path path_;
};

inline PointSource sourceOf(const std::vector<FilePoint>& points) {
  return {
      .count = points.size(), .read = [&points](std::uint64_t first, std::span<FilePoint> block) {
        const std::size_t count =
            std::min<std::size_t>(block.size(), points.size() - static_cast<std::size_t>(first));
        std::copy_n(points.begin() + static_cast<std::ptrdiff_t>(first), count, block.begin());
        return count;
      }};
}

/// Depths of a relief hit here and there: gaps, a hole, a corner that belongs to nothing, a back
/// seen through the gaps, and outliers.
inline FrontDepths gappyDepths(GridSize size, double hit_share, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(0, 1);
  FrontDepths depths(size.count(), std::numeric_limits<float>::quiet_NaN());
  for (int row = 0; row < size.rows; ++row) {
    for (int col = 0; col < size.cols; ++col) {
      const bool hit = uniform(random) < hit_share;
      const double draw = uniform(random);
      const bool hole = std::hypot(col - 0.3 * size.cols, row - 0.6 * size.rows) < 0.08 * size.cols;
      const bool corner = col + row < 0.4 * size.cols;
      if (!hit || hole || corner) continue;
      double z = 20 + 3 * std::sin(col / 19.0) * std::cos(row / 23.0);
      if (draw < 0.02) z -= 15;
      if (draw > 0.9995) z += 40;
      depths[size.index({.col = col, .row = row})] = static_cast<float>(z);
    }
  }
  return depths;
}

inline RowsOf rowsOf(const FrontDepths& depths, GridSize size) {
  return [&depths, size](int first, int rows, float* out) {
    const std::size_t start = size.index({.col = 0, .row = first});
    std::copy_n(depths.begin() + static_cast<std::ptrdiff_t>(start),
                static_cast<std::size_t>(rows) * static_cast<std::size_t>(size.cols), out);
  };
}

}  // namespace relievo::test
