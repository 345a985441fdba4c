// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "core/base/task.h"
#include "core/depth/colours/linear_light.h"
#include "core/depth/depth_map.h"

namespace relievo {

/// A stored sample: its channels and, last, alpha.
template <std::size_t Channels>
using Pixel = std::array<std::uint8_t, Channels + 1>;

/// What a cell without a colour of its own gets.
enum class ColourWish : std::uint8_t {
  none,    ///< Holes, outside.
  near,    ///< Measured: one from around, if any lies within `kBareReach` cells.
  always,  ///< Interpolated.
};
ColourWish wishOf(CellStatus origin) noexcept;

inline constexpr int kBareReach = 8;  ///< Side of the squares one of whose cells must have one.

/// Gives interpolated cells, and measured ones without a colour of their own that lie within
/// `kBareReach` cells of one that has one, the mean of the colours around them, in linear light
/// weighted by how near they are (push-pull, as core/depth/fill/push_pull.h). Their alpha becomes
/// 128. Works on bands of rows, so that the map need not be in memory, and gives the same bytes for
/// any bands: squares of `kBareReach` cells and coarser are kept, finer ones are made anew for each
/// band. For 3 channels and 1.
template <std::size_t Channels>
class ColourFill {
 public:
  /// Rows that a band must have around it, where there are any; they begin and end at multiples of
  /// kBareReach or with the map.
  static constexpr int kAround = 2 * kBareReach;

  ColourFill(GridSize size, const Transfer& transfer);

  /// The map's next rows, lowest first: a multiple of kBareReach, but for the last.
  void add(const Pixel<Channels>* pixels, int rows);
  /// After the last row. @return  false if no cell has a colour: there is nothing to fill with
  bool close(const Task& task);

  struct Band {
    int first = 0, end = 0;  ///< Rows that are filled ...
    int from = 0, to = 0;    ///< ... and rows given.
  };
  /// The band of these rows with what must be around it.
  Band bandOf(int first, int rows) const noexcept;
  /// @param around  rows band.from ... band.to - 1 as they were added
  /// @param wish    of a cell of rows band.first ... band.end - 1, counted from its first
  /// @param out     of these rows; has their colours already [any thread]
  void fill(const Band& band, const Pixel<Channels>* around,
            const std::function<ColourWish(std::size_t)>& wish, Pixel<Channels>* out) const;

 private:
  /// Cells half as many each way: means of light, and in the last channel how much is known.
  struct Layer {
    using Value = std::array<float, Channels + 1>;
    GridSize size;
    std::vector<Value> cells;
  };
  static void divide(Layer& sums);
  static Layer halved(const Layer& fine);
  static void push(Layer& fine, int fine_row, const Layer& coarse, int coarse_row);
  Layer lightOf(const Pixel<Channels>* pixels, int rows) const;

  GridSize size_;
  const Transfer* transfer_;
  Layer squares_;               ///< Of kBareReach cells.
  std::vector<char> has_some_;  ///< Which of them hold a colour.
};

/// The same for a map in memory. @param threads  as DepthRequest::threads @throw Cancelled
template <std::size_t Channels>
void fillColours(std::vector<Pixel<Channels>>& pixels, const DepthMap& map,
                 const Transfer& transfer, int threads, const Task& task);

struct GridColours;  // core/depth/colours/colours.h
/// The same for a finished map some of whose holes were filled since. [worker] @throw Cancelled
void fillColours(GridColours& colours, const DepthMap& map, const Task& task);

/// Gives samples outside the object the colour of one beside them that lies on it: a picture's
/// outline runs half a sample beyond the object and would be stone. [any thread]
void coverRim(GridColours& colours, std::span<const CellStatus> origins, GridSize size);

}  // namespace relievo
