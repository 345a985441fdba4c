// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/arguments.h"
#include "app/cli/verb.h"

namespace relievo::batch {

/// Of the verbs that make maps by tiles where `memory_mb` is given.
struct TileArguments {
  std::vector<std::string> more;  ///< Files, and what stands for files, beside the first.
  std::optional<double> memory_mb;
  std::optional<int>
      threads;      ///< Nothing: as many as there are usable cores and memory has room for.
  std::string job;  ///< Folder; empty: none.
};

/// Further files, --memory MB, --threads N and --job FOLDER.
void addTileOptions(CLI::App& verb, TileArguments& tiles);

/// Is the map to be made by tiles? @throw ArgumentError  what asks for that, without it
bool areGiven(const TileArguments& tiles);

/// The files that are read: by tiles all that the names stand for, else the one. @throw FileError
std::vector<std::filesystem::path> filesOf(const MapArguments& arguments,
                                           const TileArguments& tiles);

/// How long a step still takes, as the line of progress says it; empty while there is nothing to
/// judge by. @param seconds  since it was at `began_at`, 0 to 1; now it is at `fraction`
std::string timeLeftWords(double seconds, double began_at, double fraction);

/// Makes all levels by tiles within a budget and reports them. @pre areGiven(tiles)
/// @param finest  file of level 0 @throw Error
CommandResult runByTiles(const MapArguments& arguments, const TileArguments& tiles,
                         const std::filesystem::path& finest, const Task& task);

/// A tiled map as it is, anything else as loadForVerb; for verbs that only need windows.
Surface openForVerb(const MapArguments& arguments, const Task& task);

}  // namespace relievo::batch
