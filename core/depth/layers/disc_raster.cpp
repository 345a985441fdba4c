// SPDX-License-Identifier: BSD-3-Clause
#include "core/depth/layers/disc_raster.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>

#include "core/base/bands.h"

namespace relievo {
namespace {

constexpr float kNone = -std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kEdgeOn = 0.1F;        // Cosine; flatter discs are lines.
constexpr float kLeastCosine = 0.15F;  // For tolerances of slopes.
constexpr float kOnSurface = 1.35F;    // Spacings off the surface, across it.
constexpr float kAveraged = 0.5F;      // Of that, behind the foremost piece.
constexpr float kLowest = 1;           // Spacings along the view, behind the foremost piece.
constexpr float kRim = 0.5F;           // Spacings that a disc may reach farther before a back.
constexpr float kFarBehind = 2;        // Tolerances; nearer it is the same surface.
constexpr int kPixelsAtOnce = 32;
constexpr int kTilePixels = 16;
constexpr std::size_t kFirstOf = 4;  // One disc in so many is drawn before the others.

/// What a disc is at some pixels of a row.
struct PieceRow {
  std::size_t count = 0;
  std::array<float, kPixelsAtOnce> z{}, with_rim{}, squared_radii{};
};

/// One disc as the raster sees it.
class DrawnDisc {
 public:
  DrawnDisc(const SurfaceDisc& disc, float pixel) : disc_(disc), pixel_(pixel) {
    const float cosine = std::max(disc.normal[2], kLeastCosine);
    const float sine = std::sqrt(std::max(0.0F, 1 - cosine * cosine));
    tolerance_ = (kOnSurface * disc.spacing + sine * pixel / 2) / cosine;
    half_width_ = disc.radius * std::sqrt(std::max(0.0F, 1 - disc.normal[0] * disc.normal[0]));
    half_height_ = disc.radius * std::sqrt(std::max(0.0F, 1 - disc.normal[1] * disc.normal[1]));
  }

  float tolerance() const { return tolerance_; }
  /// No pixel of it is higher, and some room for rounding.
  float top() const {
    return disc_.centre[2] + 1.01F * disc_.radius + 1e-6F * std::abs(disc_.centre[2]);
  }
  int firstRow() const { return pixelOf(disc_.centre[1] - half_height_); }
  int lastRow() const { return pixelOf(disc_.centre[1] + half_height_); }
  int firstCol() const { return pixelOf(disc_.centre[0] - half_width_); }
  int lastCol() const { return pixelOf(disc_.centre[0] + half_width_); }

  /// Of the pixels of one row from `first` on: z of the disc in their middles, kNone beside the
  /// disc; the same with its rim; and how far from its centre that is, squared, in radii. Without a
  /// branch, for vectors.
  void depths(int first, int row, PieceRow& out) const {
    if (disc_.normal[2] <= kEdgeOn) return depthsOfLine(first, row, out);
    const SurfaceDisc disc = disc_;
    const float pixel = pixel_, limit = disc.radius * disc.radius;
    const std::size_t count = out.count;
    const float y = (static_cast<float>(row) + 0.5F) * pixel - disc.centre[1];
    const float rim = kRim * disc.spacing;
    float* const out_z = out.z.data();
    float* const out_with_rim = out.with_rim.data();
    float* const out_squared = out.squared_radii.data();
    for (std::size_t i = 0; i < count; ++i) {
      const float x =
          (static_cast<float>(first + static_cast<int>(i)) + 0.5F) * pixel - disc.centre[0];
      const float rise = -(disc.normal[0] * x + disc.normal[1] * y) / disc.normal[2];
      const float a = disc.right[0] * x + disc.right[1] * y + disc.right[2] * rise;
      const float b = disc.up[0] * x + disc.up[1] * y + disc.up[2] * rise;
      const float squared = a * a + b * b;
      const float c = (a + b) * 0.70710678F;
      const float e = (a - b) * 0.70710678F;
      const auto& reach = disc.reach;
      // What lies beyond the disc is above 0 in one of these.
      float beyond = std::max(a - reach[0], -a - reach[1]);
      beyond = std::max(beyond, std::max(b - reach[2], -b - reach[3]));
      beyond = std::max(beyond, std::max(c - reach[4], -c - reach[5]));
      beyond = std::max(beyond, std::max(e - reach[6], -e - reach[7]));
      const float off_middle = std::max(std::abs(x), std::abs(y)) - pixel / 2;
      const float beside = off_middle <= 0 ? disc.centre[2] : kNone;
      const float on_disc = disc.centre[2] + rise, part = squared / limit;
      const bool is_round = squared <= limit, is_on = is_round && beyond <= 0;
      const bool is_on_rim = is_round && beyond <= rim;
      out_z[i] = is_on ? on_disc : beside;
      out_with_rim[i] = is_on_rim ? on_disc : beside;
      out_squared[i] = is_on_rim ? part : 0.0F;
    }
  }

 private:
  void depthsOfLine(int first, int row, PieceRow& out) const {
    const float y = (static_cast<float>(row) + 0.5F) * pixel_ - disc_.centre[1];
    for (std::size_t i = 0; i < out.count; ++i) {
      const float x =
          (static_cast<float>(first + static_cast<int>(i)) + 0.5F) * pixel_ - disc_.centre[0];
      const bool is_middle = std::abs(x) <= pixel_ / 2 && std::abs(y) <= pixel_ / 2;
      out.z[i] = is_middle || isOnLine(x, y) ? disc_.centre[2] : kNone;
      out.with_rim[i] = out.z[i];
      out.squared_radii[i] = 0;
    }
  }

  /// Seen edge-on, a disc is a line as long as it reaches.
  bool isOnLine(float x, float y) const {
    const auto& n = disc_.normal;
    if (std::abs(n[0] * x + n[1] * y) > 0.71F * pixel_) return false;
    const float a = disc_.right[0] * x + disc_.right[1] * y;
    const float b = disc_.up[0] * x + disc_.up[1] * y;
    const auto& reach = disc_.reach;
    return a <= reach[0] && -a <= reach[1] && b <= reach[2] && -b <= reach[3] &&
           x * x + y * y <= disc_.radius * disc_.radius;
  }

  int pixelOf(float mm) const { return static_cast<int>(std::floor(mm / pixel_)); }

  const SurfaceDisc& disc_;
  float pixel_;
  float tolerance_ = 0;
  float half_width_ = 0, half_height_ = 0;
};

/// Rows of the raster, and columns.
struct PixelRange {
  int first_row, last_row, first_col, last_col;
};

/// What in each tile of a band is lower than all that counts there. Most discs of a closed cloud
/// lie behind its front everywhere: they are not drawn.
class TileFloors {
 public:
  TileFloors(GridSize size, int first_row, int end_row)
      : cols_(size.cols),
        first_row_(first_row),
        end_row_(end_row),
        tile_cols_((size.cols + kTilePixels - 1) / kTilePixels),
        floors_(static_cast<std::size_t>(tile_cols_) *
                    static_cast<std::size_t>((end_row - first_row + kTilePixels - 1) / kTilePixels),
                kNone) {}

  /// @param floor_of  of a pixel of the band, by its place from the band's first
  template <class FloorOf>
  void measure(FloorOf&& floor_of) {
    std::fill(floors_.begin(), floors_.end(), -kNone);
    std::size_t at = 0;
    for (int row = first_row_; row < end_row_; ++row) {
      float* const tiles = &floors_[tileOf(row, 0)];
      for (int col = 0; col < cols_; ++col, ++at) {
        float& tile = tiles[col / kTilePixels];
        tile = std::min(tile, floor_of(at));
      }
    }
  }
  bool areAbove(float top, const PixelRange& range) const {
    for (int row = range.first_row; row <= range.last_row;) {
      const float* const tiles = &floors_[tileOf(row, 0)];
      for (int col = range.first_col / kTilePixels; col <= range.last_col / kTilePixels; ++col) {
        if (!(tiles[col] > top)) return false;
      }
      row += kTilePixels - (row - first_row_) % kTilePixels;
    }
    return true;
  }

 private:
  std::size_t tileOf(int row, int col) const {
    return static_cast<std::size_t>((row - first_row_) / kTilePixels) *
               static_cast<std::size_t>(tile_cols_) +
           static_cast<std::size_t>(col / kTilePixels);
  }
  int cols_, first_row_, end_row_, tile_cols_;
  std::vector<float> floors_;
};

/// Which of the discs are drawn.
enum class Turn { first, later, all };

bool isOf(Turn turn, std::size_t disc) {
  return turn == Turn::all || (turn == Turn::first) == (disc % kFirstOf == 0);
}

/// What a disc is at one pixel.
struct DiscAt {
  float z, with_rim, squared_radii;
  std::size_t number;
};

/// visit(pixel, piece) for all pixels of a band that discs cover with their rims, but not for discs
/// all of which lies lower than the floors.
template <class Visit>
void forPixels(const std::vector<SurfaceDisc>& discs, Turn turn, GridSize size, float pixel,
               int first_row, int end_row, const TileFloors& floors, const Task& task,
               Visit&& visit) {
  PieceRow at;
  for (std::size_t i = 0; i < discs.size(); ++i) {
    if (i % 4096 == 0) task.check();
    if (!isOf(turn, i)) continue;
    const DrawnDisc disc(discs[i], pixel);
    const int last_row = std::min(disc.lastRow(), end_row - 1);
    const int last_col = std::min(disc.lastCol(), size.cols - 1);
    const int top_row = std::max(disc.firstRow(), first_row);
    const int left_col = std::max(disc.firstCol(), 0);
    if (floors.areAbove(disc.top(), {top_row, last_row, left_col, last_col})) continue;
    for (int row = top_row; row <= last_row; ++row) {
      for (int col = left_col; col <= last_col; col += kPixelsAtOnce) {
        at.count = static_cast<std::size_t>(std::min(kPixelsAtOnce, last_col - col + 1));
        disc.depths(col, row, at);
        const std::size_t first = size.index({.col = col, .row = row});
        for (std::size_t k = 0; k < at.count; ++k) {
          if (at.with_rim[k] == kNone) continue;
          visit(first + k, DiscAt{at.z[k], at.with_rim[k], at.squared_radii[k], i});
        }
      }
    }
  }
}

void drawBand(const std::vector<SurfaceDisc>& discs, const DiscRaster& raster, HiddenDiscs hidden,
              int first_row, int end_row, const Task& task, std::vector<FrontPiece>& pieces) {
  const GridSize size = raster.size;
  struct Foremost {
    float z = kNone;
    std::uint32_t disc = 0;

    void add(float other, std::size_t number) {
      if (!(other > z || (other == z && number < disc))) return;
      z = other;
      disc = static_cast<std::uint32_t>(number);
    }
  };
  struct Sum {
    Foremost front, with_rims;
    float lowest = 0;         // Of the pieces that count.
    float weight = 0, z = 0;  // z from the front, so that the sum keeps its digits.
    bool is_rim = false;
  };
  const std::size_t offset = size.index({.col = 0, .row = first_row});
  std::vector<Sum> sums(size.index({.col = 0, .row = end_row}) - offset);
  const auto pixel = static_cast<float>(raster.pixel_mm);
  TileFloors floors(size, first_row, end_row);
  // Of pieces equally high the first disc's, whichever is drawn first.
  for (const Turn turn : {Turn::first, Turn::later}) {
    forPixels(discs, turn, size, pixel, first_row, end_row, floors, task,
              [&](std::size_t at, const DiscAt& piece) {
                Sum& sum = sums[at - offset];
                sum.front.add(piece.z, piece.number);
                sum.with_rims.add(piece.with_rim, piece.number);
              });
    if (hidden == HiddenDiscs::skipped) {
      floors.measure([&](std::size_t at) { return sums[at].front.z; });
    }
  }
  // Between an edge and the last points before it chance leaves gaps, through which the back shows:
  // rims close them. Where nothing lies behind they would only make the object wider.
  const auto tolerance = [&](const Foremost& of) {
    return DrawnDisc(discs[of.disc], pixel).tolerance();
  };
  for (Sum& sum : sums) {
    if (sum.front.z == kNone) continue;
    sum.is_rim = sum.with_rims.z != sum.front.z &&
                 sum.with_rims.z > sum.front.z + kFarBehind * tolerance(sum.with_rims);
    if (sum.is_rim) sum.front = sum.with_rims;
    // A steep surface has a wide tolerance: pieces of it that lie deep would sink its upper edge.
    sum.lowest = sum.front.z - std::min(kAveraged * tolerance(sum.front),
                                        kLowest * discs[sum.front.disc].spacing);
  }
  // Pieces as near as the front's own tolerance are the same surface. No disc reaches a pixel that
  // none covers.
  if (hidden == HiddenDiscs::skipped) {
    floors.measure(
        [&](std::size_t at) { return sums[at].front.z == kNone ? -kNone : sums[at].lowest; });
  }
  forPixels(discs, Turn::all, size, pixel, first_row, end_row, floors, task,
            [&](std::size_t at, const DiscAt& piece) {
              Sum& sum = sums[at - offset];
              const float z = sum.is_rim ? piece.with_rim : piece.z;
              if (z == kNone || z < sum.lowest) return;
              // A Gaussian of half the radius: near pieces know best.
              const float weight = std::exp(-2 * piece.squared_radii);
              sum.weight += weight;
              sum.z += weight * (z - sum.front.z);
            });
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const Foremost& front = sums[i].front;
    if (front.z == kNone) continue;
    pieces[offset + i] = {.z = front.z + sums[i].z / sums[i].weight,
                          .tolerance = tolerance(front),
                          .spacing = discs[front.disc].spacing};
  }
}

}  // namespace

std::vector<FrontPiece> drawDiscs(const std::vector<SurfaceDisc>& discs, const DiscRaster& raster,
                                  HiddenDiscs hidden, const Task& task) {
  std::vector<FrontPiece> pieces(raster.size.count(), {.z = kNan, .tolerance = 0, .spacing = 0});
  const int threads = threadsFor(20 * discs.size(), 0);
  parallelFor(raster.size.rows, threads, [&](int first, int end) {
    drawBand(discs, raster, hidden, first, end, task, pieces);
  });
  return pieces;
}

}  // namespace relievo
