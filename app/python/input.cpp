// SPDX-License-Identifier: BSD-3-Clause
#include "app/python/input.h"

#include "core/base/failure.h"
#include "core/depth/rules/rasterize.h"
#include "core/session/large/tiled_surface.h"
#include "core/session/load.h"
#include "core/tiles/tiled_map.h"

namespace relievo::python {

std::shared_ptr<OpenedSurface> openSurface(const batch::MapArguments& arguments, const Task& task) {
  const SurfaceOptions options = batch::surfaceOptions(arguments);
  // Python's process has no OpenGL (docs/adr/0148).
  if (options.engine != "cpu") throw failure<MessageId::drawing_not_installed>();
  auto opened = std::make_shared<OpenedSurface>();
  opened->arguments = arguments;
  opened->surface = TiledMap::isOne(arguments.file)
                        ? openTiledSurface(arguments.file)
                        : loadSurface(arguments.file, options, rasterize,
                                      batch::importOptions(arguments.scan), task);
  return opened;
}

}  // namespace relievo::python
