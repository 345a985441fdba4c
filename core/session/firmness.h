// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/grid.h"
#include "core/base/task.h"
#include "core/region/region.h"

namespace relievo {

/// Says where the ground is firm, in place of where it was measured (docs/adr/0054): a raster over
/// the whole map, 1 where it is firm, 0 where it is as soft as ground gets.
struct FirmnessMap {
  std::string file;    ///< As it was named.
  std::string sha256;  ///< Of the bytes it was read from; empty: not taken.
  GridSize size;
  std::vector<float> parts;  ///< [0, 1], row-major, row 0 at the lowest y; no value in the file: 0.
};

/// Reads one, in a child process as importRaster does. `sha256` stays empty. [worker]
/// @throw FileError      as importRaster  @throw Cancelled
/// @throw ArgumentError  a value outside [0, 1]
FirmnessMap readFirmness(const std::filesystem::path& file, const Task& task = {});

/// Its parts at the 200 x 200 samples of a region: of the cell that each lies in, beyond the map of
/// the nearest one. Row 0 at the lowest y. [any thread]
/// @throw ArgumentError  its cells would not be square on this map, by more than one cell in all
std::vector<float> firmnessUnder(const FirmnessMap& firmness, const DetailLadder& map,
                                 const Region& region);

}  // namespace relievo
