// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/base/task.h"
#include "core/depth/colours/stored_colours.h"
#include "core/pyramid/pyramid.h"

namespace relievo {

/// Colours of every level of a pyramid, finest first, at the samples of its heights and by their
/// kernel (paper sec. 5): linear light weighted by alpha, divided by the weights, so that cells
/// without a colour leave those of their neighbours as they are. Interpolated cells count only
/// where there is nothing else. A third more memory than the finest level, which is used up.
/// The same bytes for any number of threads. [worker]
/// @param finest  of the map that `pyramid` was made of @return  empty if `finest` is
/// @throw Cancelled
std::vector<StoredColours> colourLevels(GridColours&& finest, const Pyramid& pyramid, int threads,
                                        const Task& task = {});

}  // namespace relievo
