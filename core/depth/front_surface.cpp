// SPDX-License-Identifier: BSD-3-Clause
#include "core/depth/front_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "core/base/bands.h"
#include "core/depth/front_voids.h"

namespace relievo {
namespace {

constexpr float kNone = -std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr double kPixelShare = 0.35;   // Of the spacing of the discs.
constexpr double kMostPixels = 2048;   // Across the longer side.
constexpr float kEdgeOn = 0.1F;        // Cosine; flatter discs are lines.
constexpr float kLeastCosine = 0.15F;  // For tolerances of slopes.
constexpr float kOnSurface = 1.35F;    // Spacings off the surface, across it.
constexpr float kAveraged = 0.5F;      // Of that, behind the foremost piece.
constexpr double kRough = 0.5;         // Thickness over width: noise hides the planes.
constexpr int kSquarePixels = 4;
constexpr int kPixelsAtOnce = 32;
constexpr float kLayerSpacings = 6;  // Farther apart, points behind are two layers.
constexpr std::size_t kFewDiscs = 20'000;

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
  float spacing() const { return disc_.spacing; }
  int firstRow() const { return pixelOf(disc_.centre[1] - half_height_); }
  int lastRow() const { return pixelOf(disc_.centre[1] + half_height_); }
  int firstCol() const { return pixelOf(disc_.centre[0] - half_width_); }
  int lastCol() const { return pixelOf(disc_.centre[0] + half_width_); }

  /// Of the pixels of one row from `first` on: z of the disc in their middles, kNone beside the
  /// disc; and how far from its centre that is, squared, in radii. Without a branch, for vectors.
  void depths(int first, int row, std::span<float> z, std::span<float> squared_radii) const {
    if (disc_.normal[2] <= kEdgeOn) return depthsOfLine(first, row, z, squared_radii);
    const SurfaceDisc disc = disc_;
    const float pixel = pixel_, limit = disc.radius * disc.radius;
    const std::size_t count = z.size();
    const float y = (static_cast<float>(row) + 0.5F) * pixel - disc.centre[1];
    float* const out_z = z.data();
    float* const out_squared = squared_radii.data();
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
      float beyond = std::max(squared - limit, std::max(a - reach[0], -a - reach[1]));
      beyond = std::max(beyond, std::max(b - reach[2], -b - reach[3]));
      beyond = std::max(beyond, std::max(c - reach[4], -c - reach[5]));
      beyond = std::max(beyond, std::max(e - reach[6], -e - reach[7]));
      const float off_middle = std::max(std::abs(x), std::abs(y)) - pixel / 2;
      const float beside = off_middle <= 0 ? disc.centre[2] : kNone;
      const float on_disc = disc.centre[2] + rise, part = squared / limit;
      out_z[i] = beyond <= 0 ? on_disc : beside;
      out_squared[i] = beyond <= 0 ? part : 0.0F;
    }
  }

 private:
  void depthsOfLine(int first, int row, std::span<float> z, std::span<float> squared_radii) const {
    const float y = (static_cast<float>(row) + 0.5F) * pixel_ - disc_.centre[1];
    for (std::size_t i = 0; i < z.size(); ++i) {
      const float x =
          (static_cast<float>(first + static_cast<int>(i)) + 0.5F) * pixel_ - disc_.centre[0];
      const bool is_middle = std::abs(x) <= pixel_ / 2 && std::abs(y) <= pixel_ / 2;
      z[i] = is_middle || isOnLine(x, y) ? disc_.centre[2] : kNone;
      squared_radii[i] = 0;
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

/// visit(pixel, z, squared_radii, disc) for all pixels of a band that discs cover.
template <class Visit>
void forPixels(const std::vector<SurfaceDisc>& discs, GridSize size, float pixel, int first_row,
               int end_row, const Task& task, Visit&& visit) {
  std::array<float, kPixelsAtOnce> z{}, squared_radii{};
  for (std::size_t i = 0; i < discs.size(); ++i) {
    if (i % 4096 == 0) task.check();
    const DrawnDisc disc(discs[i], pixel);
    const int last_row = std::min(disc.lastRow(), end_row - 1);
    const int last_col = std::min(disc.lastCol(), size.cols - 1);
    for (int row = std::max(disc.firstRow(), first_row); row <= last_row; ++row) {
      for (int col = std::max(disc.firstCol(), 0); col <= last_col; col += kPixelsAtOnce) {
        const auto count = static_cast<std::size_t>(std::min(kPixelsAtOnce, last_col - col + 1));
        disc.depths(col, row, {z.data(), count}, {squared_radii.data(), count});
        const std::size_t first = size.index({.col = col, .row = row});
        for (std::size_t k = 0; k < count; ++k) {
          if (z[k] != kNone) visit(first + k, z[k], squared_radii[k], disc);
        }
      }
    }
  }
}

}  // namespace

FrontSurface::FrontSurface(const ViewBlocks& points, const ViewBox& box, std::uint64_t count,
                           const Task& task) {
  task.report("Finding the front", 0);
  std::size_t wanted = kMostDiscs;
  SurfaceDiscs discs = surfaceDiscs(evenPoints(points, box, count, wanted, task), task);
  // Where the noise is as large as the spacing, planes need points farther apart.
  while (discs.roughness > kRough && wanted > kFewDiscs && count > wanted / 4) {
    wanted /= 4;
    discs = surfaceDiscs(evenPoints(points, box, count, wanted, task), task);
  }
  spacing_mm_ = discs.spacing;
  const double width = box.max.x - box.min.x;
  const double height = box.max.y - box.min.y;
  pixel_mm_ = std::max(kPixelShare * spacing_mm_, std::max(width, height) / kMostPixels);
  if (!(pixel_mm_ > 0)) pixel_mm_ = std::max({width, height, 1.0});
  size_ = {.cols = static_cast<int>(width / pixel_mm_) + 1,
           .rows = static_cast<int>(height / pixel_mm_) + 1};
  pieces_.assign(size_.count(), {.z = kNan, .tolerance = 0, .spacing = 0});
  task.report("Finding the front", 0.5);
  draw(discs.discs, task);
  lookBehind(discs.discs);
}

void FrontSurface::lookBehind(const std::vector<SurfaceDisc>& discs) {
  // Squares of two spacings: four points of a layer lie in one.
  const GridSize squares{.cols = size_.cols / kSquarePixels + 1,
                         .rows = size_.rows / kSquarePixels + 1};
  struct Square {
    bool is_covered = false;
    float low = -kNone, high = kNone, limit = 0;
  };
  std::vector<Square> found(squares.count());
  for (const SurfaceDisc& disc : discs) {
    const auto x = static_cast<double>(disc.centre[0]);
    const auto y = static_cast<double>(disc.centre[1]);
    const auto z = static_cast<double>(disc.centre[2]);
    const int col = static_cast<int>(x / pixel_mm_) / kSquarePixels;
    const int row = static_cast<int>(y / pixel_mm_) / kSquarePixels;
    if (!squares.contains({.col = col, .row = row})) continue;
    Square& square = found[squares.index({.col = col, .row = row})];
    square.is_covered = true;
    if (sideOf({x, y, z}) != Side::hidden) continue;
    square.low = std::min(square.low, disc.centre[2]);
    square.high = std::max(square.high, disc.centre[2]);
    square.limit = kLayerSpacings * disc.spacing;
  }
  double covered = 0;
  for (const Square& square : found) {
    covered += square.is_covered ? 1 : 0;
    if (square.low > square.high) continue;
    behind_.hidden += 1;
    behind_.in_layers += square.high - square.low > square.limit ? 1 : 0;
  }
  if (covered == 0) return;
  behind_.hidden /= covered;
  behind_.in_layers /= covered;
}

void FrontSurface::draw(const std::vector<SurfaceDisc>& discs, const Task& task) {
  const int threads = threadsFor(20 * discs.size(), 0);
  inBands(size_.rows, threads, [&](int first, int end) { drawBand(discs, first, end, task); });
  closeVoids(pieces_, size_, pixel_mm_, discs, task);
}

void FrontSurface::drawBand(const std::vector<SurfaceDisc>& discs, int first_row, int end_row,
                            const Task& task) {
  struct Sum {
    float front = kNone, tolerance = 0, spacing = 0;
    float weight = 0, z = 0;  // z from the front, so that the sum keeps its digits.
  };
  const std::size_t offset = size_.index({.col = 0, .row = first_row});
  std::vector<Sum> sums(size_.index({.col = 0, .row = end_row}) - offset);
  const auto pixel = static_cast<float>(pixel_mm_);
  forPixels(discs, size_, pixel, first_row, end_row, task,
            [&](std::size_t at, float z, float, const DrawnDisc& disc) {
              Sum& sum = sums[at - offset];
              if (!(z > sum.front)) return;
              sum.front = z;
              sum.tolerance = disc.tolerance();
              sum.spacing = disc.spacing();
            });
  // Pieces as near as the front's own tolerance are the same surface.
  forPixels(discs, size_, pixel, first_row, end_row, task,
            [&](std::size_t at, float z, float squared_radii, const DrawnDisc&) {
              Sum& sum = sums[at - offset];
              if (z < sum.front - kAveraged * sum.tolerance) return;
              // A Gaussian of half the radius: near pieces know best.
              const float weight = std::exp(-2 * squared_radii);
              sum.weight += weight;
              sum.z += weight * (z - sum.front);
            });
  for (std::size_t i = 0; i < sums.size(); ++i) {
    if (sums[i].front == kNone) continue;
    pieces_[offset + i] = {.z = sums[i].front + sums[i].z / sums[i].weight,
                           .tolerance = sums[i].tolerance,
                           .spacing = sums[i].spacing};
  }
}

double FrontSurface::coveredMm2() const noexcept {
  const auto pixels = std::count_if(pieces_.begin(), pieces_.end(),
                                    [](const FrontPiece& piece) { return piece.z == piece.z; });
  return static_cast<double>(pixels) * pixel_mm_ * pixel_mm_;
}

const FrontPiece* FrontSurface::pieceAt(double x_mm, double y_mm) const noexcept {
  // Rounding may carry a point of the border out by a hair.
  const double col = x_mm / pixel_mm_ + 1e-6;
  const double row = y_mm / pixel_mm_ + 1e-6;
  if (!(col >= 0 && row >= 0 && col < size_.cols && row < size_.rows)) return nullptr;
  return &pieces_[size_.index({.col = static_cast<int>(col), .row = static_cast<int>(row)})];
}

FrontSurface::Side FrontSurface::sideOf(const ViewMm& p) const noexcept {
  const FrontPiece* piece = pieceAt(p.x, p.y);
  if (piece == nullptr || std::isnan(piece->z)) return Side::stray;
  const double above = p.z - static_cast<double>(piece->z);
  if (above > static_cast<double>(piece->tolerance)) return Side::stray;
  return above < -static_cast<double>(piece->tolerance) ? Side::hidden : Side::front;
}

float FrontSurface::depthAt(double x_mm, double y_mm) const noexcept {
  const FrontPiece* own = pieceAt(x_mm, y_mm);
  if (own == nullptr || std::isnan(own->z)) return kNan;
  // Bilinear between the middles of the pixels around, of the same surface as the own one.
  const double u = x_mm / pixel_mm_ - 0.5;
  const double v = y_mm / pixel_mm_ - 0.5;
  const double u0 = std::floor(u);
  const double v0 = std::floor(v);
  double sum = 0;
  double weights = 0;
  for (int k = 0; k < 4; ++k) {
    const int col = static_cast<int>(u0) + k % 2;
    const int row = static_cast<int>(v0) + k / 2;
    if (!size_.contains({.col = col, .row = row})) continue;
    const FrontPiece& piece = pieces_[size_.index({.col = col, .row = row})];
    if (!(std::abs(piece.z - own->z) <= own->tolerance)) continue;
    const double weight = (1 - std::abs(u - col)) * (1 - std::abs(v - row));
    sum += weight * static_cast<double>(piece.z);
    weights += weight;
  }
  return weights > 0 ? static_cast<float>(sum / weights) : own->z;
}

}  // namespace relievo
