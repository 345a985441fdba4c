// SPDX-License-Identifier: BSD-3-Clause
#include "core/session/load.h"

#include <chrono>

#include "core/session/open_input.h"

namespace relievo {

Surface loadSurface(const std::filesystem::path& file, const SurfaceOptions& options,
                    const DepthEngine& engine, const ImportOptions& import, const Task& task) {
  const auto start = std::chrono::steady_clock::now();
  const auto seconds_since_start = [start] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  const OpenedInput source = openInput(file, {.import = import, .by_tiles = false}, task);
  const double read_s = seconds_since_start();
  Surface surface = source.raster ? makeSurface(*source.raster, options, task)
                                  : makeSurface(*source.scan, options, engine, task);
  surface.seconds.read = read_s;
  return surface;
}

}  // namespace relievo
