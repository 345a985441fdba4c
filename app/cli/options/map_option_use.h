// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "app/cli/arguments.h"
#include "core/session/surface.h"

namespace relievo {
struct LargeMap;
}

namespace relievo::batch {

/// A raster keeps its cells and heights, a map of ours its view and unit as well: of options that
/// would choose them it is told on stderr that they change nothing. They are no misuse, for the
/// same options may go to scans and maps alike.
void tellUnusedMapOptions(const MapArguments& arguments, const Surface& surface);
/// Likewise of a map by tiles.
void tellUnusedMapOptions(const MapArguments& arguments, const LargeMap& map);
/// Likewise of what is read of a scan, where the file is a raster.
void tellUnusedScanOptions(const ScanArguments& arguments);

/// @throw ArgumentError  options of rasters from elsewhere that go to none
void requireRasterUse(const SurfaceOptions& options, const Surface& surface);

}  // namespace relievo::batch
