// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>

#include "app/cli/arguments.h"
#include "app/cli/verb.h"

namespace relievo::batch {

/// --memory MB, of the verbs that make maps by tiles.
void addMemoryOption(CLI::App& verb, std::optional<double>& memory_mb);

/// Makes all levels by tiles within a budget and reports them.
/// @param finest  file of level 0 @throw Error
Outcome runByTiles(const MapArguments& arguments, double memory_mb,
                   const std::filesystem::path& finest, const Task& task);

/// A tiled map as it is, anything else as loadForVerb; for verbs that only need windows.
Surface openForVerb(const MapArguments& arguments, const Task& task);

}  // namespace relievo::batch
