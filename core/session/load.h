// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "core/io/import.h"
#include "core/session/surface.h"

namespace relievo {

/// Opens any file this version reads and makes its surface: scans through the import worker and
/// `engine`, rasters and our own maps as they are. [worker]
/// @throw FileError, ArgumentError, GraphicsError, Cancelled
Surface loadSurface(const std::filesystem::path& file, const SurfaceOptions& options,
                    const DepthEngine& engine, const ImportOptions& import = {},
                    const Task& task = {});

}  // namespace relievo
