// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/base/task.h"
#include "core/depth/depth_map.h"

namespace relievo {

/// Heights smoothed by a Gaussian, cut off at four standard deviations; cells that are outside do
/// not take part. The same values for any number of threads.
/// @param sigma_samples  standard deviation, > 0
/// @throw Cancelled
std::vector<float> smoothed(const DepthMap& map, double sigma_samples, const Task& task = {});

}  // namespace relievo
