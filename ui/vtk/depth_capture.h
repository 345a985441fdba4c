// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/depth/depth_request.h"

namespace relievo {

/// The paper's engine (sec. 3): reads the OpenGL depth buffer of an off-screen orthographic render,
/// MSAA off, tight clipping range, one pixel per sample, independent of windows and screen.
/// [worker; one at a time] @throw GraphicsError  no display, or grid above the driver's limit
/// @throw Cancelled
/// @return with the format of the buffer: how exact the depths are
CapturedDepths captureDepths(const DepthRequest& request, const Task& task = {});

}  // namespace relievo
