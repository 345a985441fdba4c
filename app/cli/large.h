// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>

#include "app/cli/arguments.h"
#include "app/cli/verb.h"

namespace relievo::batch {

/// Of the verbs that make maps by tiles where `memory_mb` is given.
struct TileArguments {
  std::optional<double> memory_mb;
  std::optional<int>
      threads;  ///< Nothing: as many as there are usable cores and memory has room for.
};

/// --memory MB and --threads N.
void addTileOptions(CLI::App& verb, TileArguments& tiles);

/// Is the map to be made by tiles? @throw ArgumentError  threads without that
bool areGiven(const TileArguments& tiles);

/// Makes all levels by tiles within a budget and reports them. @pre areGiven(tiles)
/// @param finest  file of level 0 @throw Error
Outcome runByTiles(const MapArguments& arguments, const TileArguments& tiles,
                   const std::filesystem::path& finest, const Task& task);

/// A tiled map as it is, anything else as loadForVerb; for verbs that only need windows.
Surface openForVerb(const MapArguments& arguments, const Task& task);

}  // namespace relievo::batch
