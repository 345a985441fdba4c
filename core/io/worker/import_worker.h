// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>

#include "core/io/raster/picture_pixels.h"
#include "core/io/raster/raster.h"
#include "core/io/read_scan.h"

namespace relievo {

/// What a worker program reads by large libraries; null where it has none.
struct WorkerLibraries {
  bool looks_first = false;  ///< Says which program reads what it does not read itself.
  ReadLibraries read = {};
  RasterEnd (*read_raster)(const std::filesystem::path&, const RasterSink&, const Task&) = nullptr;
  std::optional<StoredPixels> (*read_pixels)(const std::filesystem::path&) = nullptr;
};

/// main() of the import programs: reads one file under limits and answers its parent.
/// @return  exit status
int runImportWorker(int argc, char** argv, const WorkerLibraries& libraries);

}  // namespace relievo
