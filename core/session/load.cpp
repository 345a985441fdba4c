// SPDX-License-Identifier: BSD-3-Clause
#include "core/session/load.h"

#include <chrono>

#include "core/io/import.h"
#include "core/io/raster.h"

namespace relievo {

Surface loadSurface(const std::filesystem::path& file, const SurfaceOptions& options,
                    const DepthEngine& engine, const ImportOptions& import, const Task& task) {
  const auto start = std::chrono::steady_clock::now();
  const auto seconds_since_start = [start] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  if (looksLikeRaster(file)) {
    const RasterMap raster = importRaster(file, import, task);
    const double read_s = seconds_since_start();
    Surface surface = makeSurface(raster, options, task);
    surface.seconds.read = read_s;
    return surface;
  }
  const Scan scan = importScan(file, import, task);
  const double read_s = seconds_since_start();
  Surface surface = makeSurface(scan, options, engine, task);
  surface.seconds.read = read_s;
  return surface;
}

}  // namespace relievo
