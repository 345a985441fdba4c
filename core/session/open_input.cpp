// SPDX-License-Identifier: BSD-3-Clause
#include "core/session/open_input.h"

#include "core/session/large/memory_guard.h"
#include "core/session/large/tiled_surface.h"

namespace relievo {

OpenedInput openInput(const std::filesystem::path& file, const InputOptions& options,
                      const Task& task) {
  const InputFacts facts = options.facts ? *options.facts : inputFacts(file, task);
  OpenedInput source;
  if (facts.kind == InputKind::tiled_map && options.by_tiles) {
    source.tiled = std::make_shared<const Surface>(openTiledSurface(file, kTileCacheBytes, task));
  } else if (facts.kind == InputKind::scan) {
    ImportOptions import = options.import;
    if (!import.free_bytes) import.free_bytes = availableBytes();
    source.scan = std::make_shared<const Scan>(importScan(file, import, task));
  } else {
    source.raster = std::make_shared<const RasterMap>(importRaster(file, options.import, task));
  }
  return source;
}

}  // namespace relievo
