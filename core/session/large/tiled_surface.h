// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>

#include "core/base/task.h"
#include "core/region/window.h"
#include "core/session/surface.h"
#include "core/tiles/tiled_map.h"

namespace relievo {

/// Opens the finest level of a tiled map (TiledMap::isOne) without reading its heights: `tiles`
/// serves windows, `ladder` names all levels, `map` is the finest level of at most 1024 samples
/// across, for views of the whole. `pyramid` stays empty. [worker]
/// @throw FileError, WebLost, Cancelled  as TiledMap
Surface openTiledSurface(const std::filesystem::path& finest,
                         std::size_t cache_bytes = kTileCacheBytes, const Task& task = {});

/// The window of any surface, in memory or tiled; of a map from the web it waits for what has to be
/// fetched. [any thread] @throw as sampleWindow; FileError
RegionWindow windowOf(const Surface& surface, const Region& region, double gain = 1);

}  // namespace relievo
