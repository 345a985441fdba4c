// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <QString>

#include "core/session/open_input.h"
#include "core/session/surface.h"

namespace relievo {

/// A surface, or why there is none.
struct SurfaceOutcome {
  std::shared_ptr<const Surface> surface;
  bool cancelled = false;
  QString error, code;
  std::optional<std::uint64_t> every;  ///< E102 of a scan: one point in so many would fit.
};

/// Runs `work` and turns what it throws into words. [worker]
SurfaceOutcome outcomeOf(const std::function<std::shared_ptr<const Surface>()>& work);

/// The surface of a source by the engine that options name. [worker] @throw as makeSurface
std::shared_ptr<const Surface> makeSurface(const OpenedInput& source, const SurfaceOptions& options,
                                           const DepthEngine& depth_buffer, const Task& task);

/// How large a source will be with these options, millimetres along the file's axes. @pre bounds
FilePoint sizeMm(const OpenedInput& source, const SurfaceOptions& options);

}  // namespace relievo
