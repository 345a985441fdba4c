// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/session/surface.h"

namespace relievo {

/// Samples of one level, both ends included.
struct LevelSamples {
  int left = 0, right = 0, bottom = 0, top = 0;
};

/// The samples of a level as a map of their own, view mm, heights times `gain`; every sample's
/// origin is that of the finest cell nearest to it. For a surface that is in memory, within the
/// level. [any thread]
DepthMap levelCut(const Surface& surface, Level level, const LevelSamples& samples, double gain);

}  // namespace relievo
