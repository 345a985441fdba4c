// SPDX-License-Identifier: BSD-3-Clause
#include "core/session/open_input.h"

#include <utility>
#include <variant>

#include "core/io/import_input.h"
#include "core/session/large/memory_guard.h"
#include "core/session/large/tiled_surface.h"

namespace relievo {

OpenedInput openInput(const std::filesystem::path& file, const InputOptions& options,
                      const Task& task) {
  ImportOptions import = options.import;
  if (!import.free_bytes) import.free_bytes = availableBytes();
  OpenedInput source;
  InputFacts facts;
  if (options.facts) {
    facts = *options.facts;
  } else {
    auto found = importInput(file, import, task);
    if (auto* scan = std::get_if<Scan>(&found)) {
      source.scan = std::make_shared<const Scan>(std::move(*scan));
      return source;
    }
    facts = std::get<InputFacts>(found);
  }
  if (facts.kind == InputKind::tiled_map && options.by_tiles) {
    source.tiled = std::make_shared<const Surface>(openTiledSurface(file, kTileCacheBytes, task));
  } else if (facts.kind == InputKind::scan) {
    source.scan = std::make_shared<const Scan>(importScan(file, import, task));
  } else {
    source.raster = std::make_shared<const RasterMap>(importRaster(file, options.import, task));
  }
  return source;
}

}  // namespace relievo
