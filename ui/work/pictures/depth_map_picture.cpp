// SPDX-License-Identifier: BSD-3-Clause
#include "ui/work/pictures/depth_map_picture.h"

#include <algorithm>
#include <cmath>

#include "core/relief/relief_image.h"

namespace relievo {
namespace {

constexpr int kMostPixels = 720;
constexpr int kBins = 96;

/// Every k-th sample of the map, so that a picture of it costs no more than it shows.
DepthMap thinned(const DepthMap& map) {
  const GridSize size = map.frame.size;
  const int step = 1 + (std::max(size.cols, size.rows) - 1) / kMostPixels;
  if (step == 1) return map;
  DepthMap thin;
  thin.frame = map.frame;
  thin.frame.spacing_mm *= step;
  thin.frame.size = {(size.cols - 1) / step + 1, (size.rows - 1) / step + 1};
  for (int row = 0; row < size.rows; row += step) {
    for (int col = 0; col < size.cols; col += step) {
      thin.heights_mm.push_back(map.heightMm({col, row}));
      thin.origins.push_back(map.origin({col, row}));
    }
  }
  return thin;
}

/// Colour and pattern of what was not measured; transparent for the rest.
QRgb maskPixel(CellStatus origin, int x, int y) {
  const bool stripe = (x + y) % 6 < 2;
  const bool crossed = stripe || (x - y + 6 * kMostPixels) % 6 < 2;
  switch (origin) {
    case CellStatus::interpolated:
      return stripe ? qRgba(60, 120, 220, 255) : qRgba(60, 120, 220, 90);
    case CellStatus::base_plane:
      return crossed ? qRgba(150, 40, 110, 255) : qRgba(150, 40, 110, 110);
    case CellStatus::steep:
      return qRgba(230, 140, 20, 200);
    case CellStatus::measured:
    case CellStatus::outside:
      break;
  }
  return qRgba(0, 0, 0, 0);
}

}  // namespace

DepthMapPicture pictureOf(const Surface& surface, const Task& task) {
  return pictureOf(surface.map, task);
}

DepthMapPicture pictureOf(const DepthMap& whole, const Task& task) {
  DepthMapPicture picture;
  picture.shares = originShares(whole);
  const DepthMap map = thinned(whole);
  const ReliefLook look{.kind = ReliefKind::hillshade};
  const ReliefValues shade = reliefValues(map, look, task);
  const GridSize size = map.frame.size;
  picture.shaded = QImage(size.cols, size.rows, QImage::Format_ARGB32);
  picture.mask = QImage(size.cols, size.rows, QImage::Format_ARGB32);
  float low = 0;
  float high = 0;
  bool first = true;
  for (std::size_t i = 0; i < map.heights_mm.size(); ++i) {
    if (map.origins[i] != CellStatus::measured) continue;
    low = first ? map.heights_mm[i] : std::min(low, map.heights_mm[i]);
    high = first ? map.heights_mm[i] : std::max(high, map.heights_mm[i]);
    first = false;
  }
  picture.counts.assign(kBins, 0);
  const float per_mm = high > low ? kBins / (high - low) : 0;
  for (int row = 0; row < size.rows; ++row) {
    // A picture's first row is at the top.
    auto* shaded = reinterpret_cast<QRgb*>(picture.shaded.scanLine(size.rows - 1 - row));
    auto* mask = reinterpret_cast<QRgb*>(picture.mask.scanLine(size.rows - 1 - row));
    for (int col = 0; col < size.cols; ++col) {
      const std::size_t i = size.index({col, row});
      const CellStatus origin = map.origins[i];
      const int grey = std::isfinite(shade.values[i])
                           ? static_cast<int>(30 + 215 * std::clamp(shade.values[i], 0.0F, 1.0F))
                           : 0;
      shaded[col] =
          origin == CellStatus::outside ? qRgba(0, 0, 0, 0) : qRgba(grey, grey, grey, 255);
      mask[col] = maskPixel(origin, col, row);
      if (origin != CellStatus::measured) continue;
      const int bin = static_cast<int>((map.heights_mm[i] - low) * per_mm);
      ++picture.counts[static_cast<std::size_t>(std::clamp(bin, 0, kBins - 1))];
    }
  }
  picture.low_mm = static_cast<double>(low);
  picture.high_mm = static_cast<double>(high);
  return picture;
}

}  // namespace relievo
