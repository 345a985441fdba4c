// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "core/base/task.h"
#include "core/io/import.h"
#include "core/io/input_facts.h"
#include "core/io/raster/raster.h"
#include "core/session/surface.h"

namespace relievo {

/// What a surface is made from: one of the three.
struct OpenedInput {
  std::shared_ptr<const Scan> scan;
  std::shared_ptr<const RasterMap> raster;
  std::shared_ptr<const Surface> tiled;  ///< A map by tiles is its own surface, as it is.

  /// @pre one of them is there
  const ScanInfo& info() const { return scan ? scan->info : raster ? raster->info : tiled->info; }
};

struct InputOptions {
  ImportOptions import = {};
  bool by_tiles = true;  ///< False: a map by tiles is read whole, as the raster that it is, too.
  std::optional<InputFacts> facts = std::nullopt;  ///< If they were asked already.
};

/// The one way in: asks what a file is, and opens it. An import process says and reads it, whoever
/// wrote it and whatever it says of itself (docs/adr/0146); of a map by tiles the process reads the
/// directories, and cells are taken from where those say, each checked. Files that carry a state of
/// ours (InputFacts::host file) are opened by core/project. [worker]
/// @throw FileError, ArgumentError, Cancelled
OpenedInput openInput(const std::filesystem::path& file, const InputOptions& options = {},
                      const Task& task = {});

}  // namespace relievo
