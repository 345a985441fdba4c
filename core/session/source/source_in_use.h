// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "core/depth/view.h"
#include "core/session/nodata.h"
#include "core/session/strays.h"
#include "core/session/surface.h"
#include "core/tiles/points/point_source.h"

namespace relievo {

/// The part of a file's points that a map by tiles is made from; what ScanInUse is for points in
/// memory, by the same rule.
struct SourceInUse {
  PointSource source;                           ///< Points that are left out are not finite.
  std::function<bool(const FilePoint&)> keeps;  ///< Which are not; null: all are in use.
  SourceBounds bounds;  ///< Of these points, in view mm as `view_from_file` gives them.
  Strays strays;
  std::uint64_t missing = 0;
  std::optional<SuspectHeight> suspect = std::nullopt;  ///< Left out though nobody said so.
};

/// Strays and heights that stand for none are decided from all points, strays seen along the view's
/// axes; where there are some it takes another look at the file. [worker]
/// @param sample          points of the file without strays: where its middle is
/// @param view_from_file  rotation and scale
/// @param processes       that ask for the same; null: this one alone
/// @throw FileError  nothing is left; Cancelled
SourceInUse sourceInUse(PointSource all, const Scan& sample, const Rotation& rotation,
                        const ViewFromFile& view_from_file, const SurfaceOptions& options,
                        int threads, const Task& task, Exchange* processes = nullptr);

}  // namespace relievo
