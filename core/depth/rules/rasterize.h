// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/depth/depth_request.h"

namespace relievo {

/// The CPU depth engine, in double precision: triangles by z-buffer at the sample points, edges
/// included; points by the request's rule. Deterministic. [worker]
/// @throw Cancelled
CapturedDepths rasterize(const DepthRequest& request, const Task& task = {});

}  // namespace relievo
