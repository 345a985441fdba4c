// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <QString>

#include "core/io/raster.h"
#include "core/session/surface.h"

namespace relievo {

/// What surfaces are made from: one of the three.
struct SurfaceSource {
  std::shared_ptr<const Scan> scan;
  std::shared_ptr<const RasterMap> raster;
  std::shared_ptr<const Surface> tiled;  ///< A map by tiles is its own surface, as it is.

  const ScanInfo& info() const { return scan ? scan->info : raster ? raster->info : tiled->info; }
};

/// A surface, or why there is none.
struct SurfaceOutcome {
  std::shared_ptr<const Surface> surface;
  bool cancelled = false;
  QString error, code;
};

/// Runs `work` and turns what it throws into words. [worker]
SurfaceOutcome outcomeOf(const std::function<std::shared_ptr<const Surface>()>& work);

/// The surface of a source by the engine that options name. [worker] @throw as makeSurface
std::shared_ptr<const Surface> makeSurface(const SurfaceSource& source,
                                           const SurfaceOptions& options,
                                           const DepthEngine& depth_buffer, const Task& task);

}  // namespace relievo
