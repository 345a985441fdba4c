// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "app/cli/state.h"
#include "app/cli/verb.h"

namespace relievo::batch {

/// Draws again what a picture of ours shows and compares the pixels with those that it has; writes
/// nothing. Exit status 5 where any pixel differs.
/// @param picture  its `from_image` is the picture  @param given  the scan; empty: as it says
/// @throw ArgumentError, FileError, GraphicsError, Cancelled
CommandResult compareFigure(const HostFileArguments& picture, const std::string& given,
                            const Task& task);

}  // namespace relievo::batch
