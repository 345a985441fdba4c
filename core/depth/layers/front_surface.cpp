// SPDX-License-Identifier: BSD-3-Clause
#include "core/depth/layers/front_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "core/depth/layers/front_voids.h"

namespace relievo {
namespace {

constexpr float kNone = -std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr double kPixelShare = 0.35;  // Of the spacing of the discs.
constexpr double kMostPixels = 2048;  // Across the longer side.
constexpr double kRough = 0.5;        // Thickness over width: noise hides the planes.
constexpr int kSquarePixels = 4;
constexpr float kLayerSpacings = 6;            // Farther apart, points behind are two layers.
constexpr double kDeviationOfMedian = 1.4826;  // Of normal errors.
constexpr std::size_t kFewDiscs = 20'000;

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
  task.report("Finding the front", 0.5);
  pieces_ =
      drawDiscs(discs.discs, {.size = size_, .pixel_mm = pixel_mm_}, HiddenDiscs::skipped, task);
  closeVoids(pieces_, size_, pixel_mm_, discs.discs, task);
  measureNoise(discs.discs);
  lookBehind(discs.discs);
}

void FrontSurface::measureNoise(const std::vector<SurfaceDisc>& discs) {
  std::vector<float> off;
  for (const SurfaceDisc& disc : discs) {
    const ViewMm centre{static_cast<double>(disc.centre[0]), static_cast<double>(disc.centre[1]),
                        static_cast<double>(disc.centre[2])};
    if (sideOf(centre) != Side::front) continue;
    off.push_back(std::abs(disc.centre[2] - depthAt(centre.x, centre.y)));
  }
  if (off.empty()) return;
  const auto middle = off.begin() + static_cast<std::ptrdiff_t>(off.size() / 2);
  std::nth_element(off.begin(), middle, off.end());
  noise_mm_ = kDeviationOfMedian * static_cast<double>(*middle);
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
