// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>

#include "core/base/task.h"
#include "core/io/import.h"
#include "core/session/surface.h"

namespace relievo {

/// What can be shown of a large file long before it is read whole. Nothing to touch or to measure
/// on: heights are those of a sample.
struct FirstView {
  Surface surface;
  std::uint64_t used = 0, all = 0;  ///< Points; samples of the finest level for a map by tiles.
};

struct FirstViewOptions {
  /// Files with fewer points are read sooner than looked at.
  std::uint64_t least_points = 4'000'000;
  std::function<void(const FirstView& view)> on_view;  ///< [worker]
};

/// Calls `on_view` with a surface from some 250 000 points, then, if the file has 20 000 000 or
/// more, with one from 2 000 000; for a map by tiles with a coarse level. Not at all for small
/// files, meshes, other rasters and formats that must be read from their beginning.
/// What is wrong with a file is left for its reader to say. [worker]
/// @throw Cancelled
void makeFirstViews(const std::filesystem::path& file, const SurfaceOptions& options,
                    const ImportOptions& import, const FirstViewOptions& views,
                    const Task& task = {});

}  // namespace relievo
