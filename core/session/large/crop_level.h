// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/session/surface.h"

namespace relievo {

/// Where the samples of a level lie, in memory or by tiles.
/// @throw ArgumentError  no such level
const GridFrame& levelFrame(const Surface& surface, Level level);

/// Samples of one level, both ends included.
struct LevelSamples {
  int left = 0, right = 0, bottom = 0, top = 0;
};

/// The samples of a level as a map of their own, view mm, heights times `gain`; every sample's
/// origin is that of the finest cell nearest to it. The same for a map in memory and by tiles.
/// [any thread] @pre within the level @throw FileError  as TiledMap::part
DepthMap cropLevel(const Surface& surface, Level level, const LevelSamples& samples, double gain);

/// A whole level like that.
DepthMap cropLevel(const Surface& surface, Level level);

}  // namespace relievo
