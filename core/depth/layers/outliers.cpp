// SPDX-License-Identifier: BSD-3-Clause
#include "core/depth/layers/outliers.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace relievo {
namespace {

constexpr std::size_t kEnoughOthers = 8;  // Fewer do not say where the surface is.
constexpr double kTogether = 0.75;        // Share of the others near their median.

/// The cells around one cell, cut at the borders of the rows.
class Around {
 public:
  Around(const RowPoints& rows, int col, int row, int radius)
      : rows_(rows),
        first_col_(std::max(col - radius, 0)),
        end_col_(std::min(col + radius + 1, rows.cols)),
        first_row_(std::max(row - radius, rows.first_row)),
        end_row_(std::min(row + radius + 1, rows.end_row)) {}

  std::size_t others() const {
    std::size_t count = 0;
    for (int row = first_row_; row < end_row_; ++row) {
      count += rows_.count(first_col_, end_col_, row);
    }
    return count - 1;
  }

  bool hasNeighbour(const PlacedPoint& point, float limit) const {
    for (int row = first_row_; row < end_row_; ++row) {
      for (const PlacedPoint& other : rows_.of(first_col_, end_col_, row)) {
        if (&other != &point && std::abs(other.z - point.z) <= limit) return true;
      }
    }
    return false;
  }

  /// Do the points other than this one lie together?
  bool othersAgree(const PlacedPoint& point, float limit, std::vector<float>& scratch) const {
    scratch.clear();
    for (int row = first_row_; row < end_row_; ++row) {
      for (const PlacedPoint& other : rows_.of(first_col_, end_col_, row)) {
        if (&other != &point) scratch.push_back(other.z);
      }
    }
    const auto middle = scratch.begin() + static_cast<std::ptrdiff_t>(scratch.size() / 2);
    std::nth_element(scratch.begin(), middle, scratch.end());
    const float median = *middle;
    const auto near = std::count_if(scratch.begin(), scratch.end(),
                                    [&](float z) { return std::abs(z - median) <= limit; });
    return static_cast<double>(near) >= kTogether * static_cast<double>(scratch.size());
  }

 private:
  const RowPoints& rows_;
  int first_col_, end_col_, first_row_, end_row_;
};

bool isOutlier(const RowPoints& rows, int col, int row, const PlacedPoint& point, float limit,
               std::vector<float>& scratch) {
  for (int radius = 1; radius <= kOutlierReach; ++radius) {
    const Around around(rows, col, row, radius);
    if (around.hasNeighbour(point, limit)) return false;
    if (around.others() >= kEnoughOthers) return around.othersAgree(point, limit, scratch);
  }
  return false;
}

/// The points of a row in their order: most have the one before or after them, in their own cell or
/// the next, for a neighbour, and need no further look.
class RowWalk {
 public:
  RowWalk(const RowPoints& rows, int row, float limit) : rows_(rows), row_(row), limit_(limit) {}

  /// look(point, col) for the others.
  template <class Look>
  void forDoubtful(Look&& look) {
    const PlacedPoint* before = nullptr;
    int col_before = 0;
    bool is_certain = true;
    for (int col = 0; col < rows_.cols; ++col) {
      for (const PlacedPoint& point : rows_.of(col, col + 1, row_)) {
        const bool near =
            before != nullptr && col - col_before <= 1 && std::abs(point.z - before->z) <= limit_;
        if (!near && !is_certain) look(*before, col_before);
        before = &point;
        col_before = col;
        is_certain = near;
      }
    }
    if (!is_certain) look(*before, col_before);
  }

 private:
  const RowPoints& rows_;
  int row_;
  float limit_;
};

bool hasTwin(std::span<const PlacedPoint> cell, const PlacedPoint& point, float limit) {
  return std::any_of(cell.begin(), cell.end(), [&](const PlacedPoint& other) {
    return &other != &point && std::abs(other.z - point.z) <= limit;
  });
}

}  // namespace

std::size_t dropOutliers(RowPoints& rows, double spacing_mm, const CellRange& counted) {
  const auto limit = static_cast<float>(kOutlierCells * spacing_mm);
  std::vector<std::uint32_t> outliers;  // Places in rows.points, rising.
  std::vector<float> scratch;
  std::size_t count = 0;
  for (int row = rows.first_row; row < rows.end_row; ++row) {
    RowWalk(rows, row, limit).forDoubtful([&](const PlacedPoint& point, int col) {
      const auto cell = rows.of(col, col + 1, row);
      if (hasTwin(cell, point, limit) || !isOutlier(rows, col, row, point, limit, scratch)) return;
      outliers.push_back(static_cast<std::uint32_t>(&point - rows.points.data()));
      count += contains(counted, {.col = col, .row = row}) ? 1 : 0;
    });
  }
  if (outliers.empty()) return 0;
  // Close up the list and move the starts by the outliers before them.
  std::size_t next = 0;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < rows.points.size(); ++i) {
    if (next < outliers.size() && outliers[next] == i) {
      ++next;
    } else {
      rows.points[kept++] = rows.points[i];
    }
  }
  rows.points.resize(kept);
  std::size_t before = 0;
  for (std::uint32_t& start : rows.starts) {
    while (before < outliers.size() && outliers[before] < start) ++before;
    start -= static_cast<std::uint32_t>(before);
  }
  return count;
}

}  // namespace relievo
