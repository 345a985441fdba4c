// SPDX-License-Identifier: BSD-3-Clause
#include "core/tiles/colours/band_colours.h"

#include <algorithm>
#include <cstdint>

#include "core/base/threads.h"
#include "core/tiles/tile_layout.h"

namespace relievo {
namespace {

/// A cell without a colour of its own keeps its wish where others have alpha, until it is filled.
constexpr std::uint8_t wishByte(ColourWish wish) {
  return static_cast<std::uint8_t>(wish);
}
static_assert(wishByte(ColourWish::always) < kStoredAlpha);

}  // namespace

/// Colours or intensities.
template <std::size_t Channels>
struct BandColours::Kind {
  using Band = typename ColourFill<Channels>::Band;

  Kind(GridSize map, const Transfer& transfer_in, const std::filesystem::path& folder)
      : size(map), transfer(transfer_in), rows(map, 0, folder), fill(map, transfer_in) {}

  /// Keeps the rows of a band. @param pixels  with wishes, which are taken out
  void keep(int first_row, int count) {
    rows.write(first_row, count, made.data());
    for (Pixel<Channels>& pixel : made) {
      if (pixel[Channels] == kStoredAlpha) {
        ++own_cells;
      } else {
        pixel[Channels] = 0;
      }
    }
    fill.add(made.data(), count);
  }

  /// Rows of a band as they were kept, filled.
  std::vector<Pixel<Channels>> filled(int first_row) const {
    const Band band = fill.bandOf(first_row, kTileSide);
    const auto cols = static_cast<std::size_t>(size.cols);
    std::vector<Pixel<Channels>> around(cols * static_cast<std::size_t>(band.to - band.from));
    rows.read(band.from, band.to - band.from, around.data());
    const std::size_t start = cols * static_cast<std::size_t>(band.first - band.from);
    const std::size_t count = cols * static_cast<std::size_t>(band.end - band.first);
    std::vector<ColourWish> wishes(count, ColourWish::none);
    for (std::size_t i = 0; i < around.size(); ++i) {
      std::uint8_t& alpha = around[i][Channels];
      if (alpha == kStoredAlpha) continue;
      if (i >= start && i < start + count) wishes[i - start] = static_cast<ColourWish>(alpha);
      alpha = 0;
    }
    const auto own = around.begin() + static_cast<std::ptrdiff_t>(start);
    std::vector<Pixel<Channels>> out(own, own + static_cast<std::ptrdiff_t>(count));
    fill.fill(
        band, around.data(), [&](std::size_t i) { return wishes[i]; }, out.data());
    return out;
  }

  GridSize size;
  const Transfer& transfer;
  RowStoreOf<Pixel<Channels>> rows;
  ColourFill<Channels> fill;
  std::vector<Pixel<Channels>> made;  ///< Of the band that is being made.
  bool any = false;
  std::size_t own_cells = 0;
};

namespace {

/// Sums of one tile.
template <template <std::size_t> class CellSums>
struct TileSums {
  std::vector<CellSums<3>> colours;
  std::vector<CellSums<1>> intensities;
};

/// The tile's place in the band that is being made.
struct TilePlace {
  GridSize tile, band;
  int first_col = 0;

  std::size_t inBand(std::size_t cell) const {
    const auto at = static_cast<int>(cell);
    return band.index({.col = first_col + at % tile.cols, .row = at / tile.cols});
  }
};

template <std::size_t Channels, class CellSums>
void placePixels(const std::vector<CellSums>& cells, const TilePlace& place,
                 const std::vector<CellStatus>& origins, const Transfer& transfer,
                 std::vector<Pixel<Channels>>& out) {
  for (std::size_t cell = 0; cell < cells.size(); ++cell) {
    const std::size_t i = place.inBand(cell);
    out[i] = pixelOf<Channels>(cells[cell], transfer);
    if (!cells[cell].any()) out[i][Channels] = wishByte(wishOf(origins[i]));
  }
}

}  // namespace

BandColours::BandColours(const ValueStore& store, const GridFrame& frame,
                         const IntensityCounts& counts, const BandColourOptions& options)
    : store_(store), frame_(frame), options_(options), stretch_(counts) {
  if (options.colours) {
    colours_ = std::make_unique<Kind<3>>(frame.size, sRgb(), options.spill_folder);
  }
  if (options.intensities) {
    intensities_ = std::make_unique<Kind<1>>(frame.size, proportional(), options.spill_folder);
  }
}

BandColours::~BandColours() = default;

std::size_t BandColours::memoryBytes(GridSize map, int threads) noexcept {
  // A row of tiles with its rim as light of single cells and of squares, as pixels and as heights;
  // each thread's sums; squares of 64 cells of the whole map.
  constexpr std::size_t kBytesPerCell = 45, kRows = kTileSide + 2 * ColourFill<3>::kAround;
  constexpr std::size_t kBytesOfSums = 24;
  return kBytesPerCell * kRows * static_cast<std::size_t>(map.cols) +
         kBytesOfSums * kTileSide * kTileSide * static_cast<std::size_t>(threads) + map.count();
}

void BandColours::add(const float* heights_mm, const CellStatus* origins, const Task& task) {
  heights_mm_.insert(heights_mm_.end(), heights_mm, heights_mm + frame_.size.cols);
  origins_.insert(origins_.end(), origins, origins + frame_.size.cols);
  const int rows = static_cast<int>(origins_.size() / static_cast<std::size_t>(frame_.size.cols));
  if (rows < kTileSide && first_row_ + rows < frame_.size.rows) return;
  makeBand(task);
  first_row_ += rows;
  heights_mm_.clear();
  origins_.clear();
}

namespace {

/// Adds some of a tile's points that lie in the layer of their cell.
template <template <std::size_t> class CellSums>
void sumTile(std::span<const ValuePoint> points, const TilePlace& place,
             const std::vector<float>& heights_mm, const std::vector<CellStatus>& origins,
             double spacing_mm, const IntensityStretch& stretch, TileSums<CellSums>& sums) {
  const Transfer& transfer = sRgb();
  for (const ValuePoint& p : points) {
    const std::size_t i = place.inBand(p.cell);
    if (!takesColours(origins[i]) || !isOfLayer(p.z, heights_mm[i], spacing_mm)) continue;
    if (!sums.colours.empty() && p.colour[3] != 0) {
      sums.colours[p.cell].add(
          {transfer.light[p.colour[0]], transfer.light[p.colour[1]], transfer.light[p.colour[2]]},
          p.z);
    }
    if (!sums.intensities.empty()) sums.intensities[p.cell].add({stretch.light(p.intensity)}, p.z);
  }
}

}  // namespace

void BandColours::makeBand(const Task& task) {
  const TileLayout& layout = store_.layout();
  const int tile_row = first_row_ / kTileSide;
  const GridSize band{
      .cols = frame_.size.cols,
      .rows = static_cast<int>(origins_.size() / static_cast<std::size_t>(frame_.size.cols))};
  measured_ +=
      static_cast<std::size_t>(std::count_if(origins_.begin(), origins_.end(), takesColours));
  if (colours_) colours_->made.assign(band.count(), {});
  if (intensities_) intensities_->made.assign(band.count(), {});
  const auto make = [&]<template <std::size_t> class CellSums>(int tile) {
    const TilePlace place{
        .tile = layout.sizeOf(tile), .band = band, .first_col = layout.firstCell(tile).col};
    TileSums<CellSums> sums;
    if (colours_) sums.colours.resize(place.tile.count());
    if (intensities_) sums.intensities.resize(place.tile.count());
    store_.forEachPiece(tile, [&](std::span<const ValuePoint> points) {
      sumTile(points, place, heights_mm_, origins_, frame_.spacing_mm, stretch_, sums);
    });
    if (colours_) {
      placePixels<3>(sums.colours, place, origins_, colours_->transfer, colours_->made);
    }
    if (intensities_) {
      placePixels<1>(sums.intensities, place, origins_, intensities_->transfer, intensities_->made);
    }
  };
  inParts(0, static_cast<std::uint64_t>(layout.across()), store_.threads(),
          [&](int, std::uint64_t first, std::uint64_t end) {
            for (auto x = static_cast<int>(first); x < static_cast<int>(end); ++x) {
              task.check();
              const int tile = tile_row * layout.across() + x;
              if (options_.rule == ColourRule::winner) {
                make.template operator()<FrontCell>(tile);
              } else {
                make.template operator()<MeanCell>(tile);
              }
            }
          });
  if (colours_) colours_->keep(first_row_, band.rows);
  if (intensities_) intensities_->keep(first_row_, band.rows);
}

void BandColours::close(const Task& task) {
  if (colours_) colours_->any = colours_->fill.close(task);
  if (intensities_) intensities_->any = intensities_->fill.close(task);
}

bool BandColours::hasColours() const noexcept {
  return colours_ && colours_->any;
}

bool BandColours::hasIntensities() const noexcept {
  return intensities_ && intensities_->any;
}

std::size_t BandColours::colouredCells() const noexcept {
  return colours_ ? colours_->own_cells : 0;
}

std::size_t BandColours::intensityCells() const noexcept {
  return intensities_ ? intensities_->own_cells : 0;
}

void BandColours::write(const TakeRow& take, const Task& task) const {
  const auto cols = static_cast<std::size_t>(frame_.size.cols);
  for (int first = 0; first < frame_.size.rows; first += kTileSide) {
    task.check();
    task.report("Writing colours", static_cast<double>(first) / frame_.size.rows);
    std::vector<Rgba> colours;
    std::vector<GreyAlpha> intensities;
    if (hasColours()) colours = colours_->filled(first);
    if (hasIntensities()) intensities = intensities_->filled(first);
    const int rows = std::min(kTileSide, frame_.size.rows - first);
    for (std::size_t row = 0; row < static_cast<std::size_t>(rows); ++row) {
      take(hasColours() ? &colours[row * cols] : nullptr,
           hasIntensities() ? &intensities[row * cols] : nullptr);
    }
  }
}

}  // namespace relievo
