// SPDX-License-Identifier: BSD-3-Clause
#include "core/depth/layers/front_voids.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>

#include "core/base/bands.h"

namespace relievo {
namespace {

// Points scattered by chance leave a circle of this radius, in their spacing, free once in 280 000.
constexpr float kVoidRadius = 2;
// A void narrower than a spacing may be longer: it has the same area, and no point fits into it.
constexpr float kNarrow = 0.25F;  // Of the widest void.
constexpr float kLonger = 1.5F;
constexpr int kMostSteps = 64;       // Pixels that are looked at in one direction.
constexpr float kWallShare = 0.25F;  // Of the points that a wall around a hollow would have.
constexpr float kFewestOfWall = 2;
constexpr float kNone = -std::numeric_limits<float>::infinity();
constexpr std::size_t kUnknown = std::numeric_limits<std::size_t>::max();
constexpr std::array<std::array<int, 2>, 8> kDirections{
    {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, -1}, {1, -1}, {-1, 1}}};

/// Pixels of one void, connected, and how many points a wall around it would have and has.
struct Void {
  std::size_t pixels = 0;
  float wall_height = 0;  // Sum over the pixels.
  float spacing = 0;      // Likewise.
  std::size_t on_wall = 0;

  bool isHollow(float pixel_mm) const {
    const auto count = static_cast<float>(pixels);
    const float around = 4 * std::sqrt(count) * pixel_mm;
    const float mean_spacing = spacing / count;
    const float expected = around * wall_height / count / (mean_spacing * mean_spacing);
    return static_cast<float>(on_wall) >= std::max(kFewestOfWall, kWallShare * expected);
  }
};

/// A pixel that the front surrounds, what would close it, and the void it is in.
struct Closing {
  FrontPiece piece;
  std::size_t number = kUnknown;
};

class VoidFinder {
 public:
  VoidFinder(const std::vector<FrontPiece>& pieces, GridSize size, double pixel_mm)
      : pieces_(pieces), size_(size), pixel_mm_(static_cast<float>(pixel_mm)) {
    float widest = 0;
    for (const FrontPiece& piece : pieces) widest = std::max(widest, piece.spacing);
    // A void is no longer than twice this from rim to rim, so no rim is farther off.
    const float farthest = 2 * kLonger * kVoidRadius * widest / pixel_mm_;
    most_steps_ = farthest < kMostSteps ? static_cast<int>(farthest) + 2 : kMostSteps;
    most_steps_ = std::min(most_steps_, kMostSteps);
  }

  void find(const Task& task) {
    std::vector<std::map<std::size_t, FrontPiece>> rows(static_cast<std::size_t>(size_.rows));
    parallelFor(size_.rows, threadsFor(16 * size_.count(), 0), [&](int first, int end) {
      for (int row = first; row < end; ++row) {
        if (row % 16 == 0) task.check();
        for (int col = 0; col < size_.cols; ++col) {
          const Cell pixel{.col = col, .row = row};
          if (const auto piece = frontAround(pixel)) {
            rows[static_cast<std::size_t>(row)].emplace(size_.index(pixel), *piece);
          }
        }
      }
    });
    for (const auto& row : rows) {
      for (const auto& [pixel, piece] : row) closings_.emplace(pixel, Closing{.piece = piece});
    }
    for (auto& [pixel, closing] : closings_) {
      if (closing.number == kUnknown) addVoid(pixel);
    }
  }

  /// Looks whose points stand on walls of the voids.
  void countWalls(const std::vector<SurfaceDisc>& discs) {
    if (closings_.empty()) return;
    for (const SurfaceDisc& disc : discs) {
      const int col = static_cast<int>(disc.centre[0] / pixel_mm_);
      const int row = static_cast<int>(disc.centre[1] / pixel_mm_);
      std::size_t counted = kUnknown;  // Once for a void, however many of its pixels are near.
      for (int r = row - 1; r <= row + 1; ++r) {
        for (int c = col - 1; c <= col + 1; ++c) {
          const Cell near{.col = c, .row = r};
          if (!size_.contains(near)) continue;
          const auto entry = closings_.find(size_.index(near));
          if (entry == closings_.end() || entry->second.number == counted) continue;
          if (!isBetween(disc.centre[2], entry->first, entry->second.piece)) continue;
          counted = entry->second.number;
          ++voids_[counted].on_wall;
        }
      }
    }
  }

  void closeInto(std::vector<FrontPiece>& pieces) const {
    for (const auto& [pixel, closing] : closings_) {
      if (!voids_[closing.number].isHollow(pixel_mm_)) pieces[pixel] = closing.piece;
    }
  }

 private:
  /// The surface in front around a pixel, weighted by distance; nothing if one side is open.
  std::optional<FrontPiece> frontAround(Cell pixel) const {
    const float own = pieces_[size_.index(pixel)].z;
    const float deep = std::isnan(own) ? kNone : own;
    FrontPiece sum{.z = 0, .tolerance = 0, .spacing = 0};
    float weights = 0;
    // Of each two directions: the void from side to side, and how wide one is at most.
    std::array<float, kDirections.size() / 2> across{}, widest{};
    for (std::size_t i = 0; i < kDirections.size(); ++i) {
      float distance = 0;
      const FrontPiece* piece = frontToward(pixel, kDirections[i], deep, distance);
      if (piece == nullptr) return std::nullopt;
      across[i / 2] += distance;
      widest[i / 2] += kVoidRadius * piece->spacing;
      if (i % 2 == 1 && across[i / 2] > kLonger * widest[i / 2]) return std::nullopt;
      const float weight = 1 / (distance * distance);
      weights += weight;
      sum.z += weight * piece->z;
      sum.tolerance += weight * piece->tolerance;
      sum.spacing += weight * piece->spacing;
    }
    for (std::size_t i = 0; i < across.size(); ++i) {
      const std::size_t crosswise = i ^ 1U;
      const bool is_narrow = across[crosswise] <= kNarrow * widest[crosswise];
      if (across[i] > (is_narrow ? kLonger : 1) * widest[i]) return std::nullopt;
    }
    return FrontPiece{.z = sum.z / weights,
                      .tolerance = sum.tolerance / weights,
                      .spacing = sum.spacing / weights};
  }

  const FrontPiece* frontToward(Cell from, const std::array<int, 2>& direction, float deep,
                                float& distance) const {
    const bool is_diagonal = direction[0] != 0 && direction[1] != 0;
    const float stride = pixel_mm_ * (is_diagonal ? 1.41421356F : 1.0F);
    for (int step = 1; step <= most_steps_; ++step) {
      const Cell near{.col = from.col + step * direction[0], .row = from.row + step * direction[1]};
      if (!size_.contains(near)) return nullptr;
      const FrontPiece& piece = pieces_[size_.index(near)];
      distance = static_cast<float>(step) * stride;
      if (piece.z > deep + 2 * piece.tolerance) return &piece;  // Not where there is none.
    }
    return nullptr;
  }

  /// All pixels that are connected to one of them.
  void addVoid(std::size_t start) {
    const auto cols = static_cast<std::size_t>(size_.cols);
    const std::size_t number = voids_.size();
    Void& found = voids_.emplace_back();
    closings_.at(start).number = number;
    std::vector<std::size_t> waiting{start};
    while (!waiting.empty()) {
      const std::size_t at = waiting.back();
      waiting.pop_back();
      const FrontPiece& piece = closings_.at(at).piece;
      const float deep = pieces_[at].z;
      ++found.pixels;
      found.spacing += piece.spacing;
      // Without a back there is no wall but what the points show: a spacing of it counts.
      found.wall_height += std::isnan(deep) ? piece.spacing : piece.z - deep;
      for (const std::size_t next : {at - 1, at + 1, at - cols, at + cols}) {
        const auto other = closings_.find(next);
        if (other == closings_.end() || other->second.number != kUnknown) continue;
        other->second.number = number;
        waiting.push_back(next);
      }
    }
  }

  bool isBetween(float z, std::size_t pixel, const FrontPiece& front) const {
    return z < front.z - front.tolerance && !(z <= pieces_[pixel].z + front.tolerance);
  }

  const std::vector<FrontPiece>& pieces_;
  GridSize size_;
  float pixel_mm_;
  int most_steps_ = kMostSteps;
  std::map<std::size_t, Closing> closings_;  // By pixel.
  std::vector<Void> voids_;
};

}  // namespace

void closeVoids(std::vector<FrontPiece>& pieces, GridSize size, double pixel_mm,
                const std::vector<SurfaceDisc>& discs, const Task& task) {
  VoidFinder finder(pieces, size, pixel_mm);
  finder.find(task);
  finder.countWalls(discs);
  finder.closeInto(pieces);
}

}  // namespace relievo
