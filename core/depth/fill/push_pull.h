// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include "core/base/grid.h"
#include "core/depth/fill/mask.h"

namespace relievo {

/// One grid of push-pull: values, and how much is known of each, [0, 1]. Half as wide and high as
/// the next finer one, rounded up.
struct PushPullLayer {
  GridSize size;
  std::vector<float> values, weights;
};

/// The next coarser layer: each cell is the weighted mean of its up to four fine cells.
PushPullLayer pulled(const PushPullLayer& fine);

/// Completes `fine` from the completed next coarser layer, bilinear between its cells. A band of
/// rows of a larger grid gives the bytes of the whole grid, except within one coarse row of its
/// border, if it begins at an even row and `coarse` is the band of the rows half as high.
void pushInto(PushPullLayer& fine, const PushPullLayer& coarse);

// Push-pull gives every cell without a value a smooth one from the known cells around it, by
// averaging upward through coarser grids and interpolating back down (Gortler et al. 1996, "The
// Lumigraph", sec. 3.5). Known cells keep their value. The finest grid is not kept as a layer: what
// is known of its cells is one or nothing.

/// The layer above the finest grid. @param known  1: the cell's value counts
PushPullLayer pulledFrom(std::span<const float> values, const Mask& known, GridSize size);

/// Gives the cells that are not known their values from the completed layer above them. As for
/// pushInto, a band's values beside its border are off.
void pushIntoUnknown(std::vector<float>& values, const Mask& known, GridSize size,
                     const PushPullLayer& coarse);

/// The averages that reach a cell beside an edge come from both its sides, so that single cells can
/// end up far off all that is known right beside them. Limits the values of the cells of `gaps` to
/// those of their known neighbours without the lowest and the highest, where at least four of the
/// eight are known; then they count as known themselves, for `kNeighbourRounds` rounds. Looks so
/// many cells around.
/// @param known  0 in the cells of `gaps`; used up
void keepWithinNeighbours(std::vector<float>& values, Mask&& known, const Mask& gaps,
                          GridSize size);

inline constexpr int kNeighbourRounds = 4;

}  // namespace relievo
