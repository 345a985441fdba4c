// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "core/io/lzf.h"

namespace relievo {

struct RasterMap;  // core/io/raster.h

/// What a worker program reads by large libraries; null where it has none.
struct WorkerLibraries {
  UnpackLzf unpack_lzf = nullptr;
  RasterMap (*read_raster)(const std::filesystem::path&) = nullptr;
};

/// main() of the import programs: reads one file under limits and answers its parent.
/// @return  exit status
int runImportWorker(int argc, char** argv, const WorkerLibraries& libraries);

}  // namespace relievo
