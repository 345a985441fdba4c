// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "app/cli/arguments.h"
#include "core/session/surface.h"

namespace relievo::batch {

/// A raster keeps its cells and heights, a map of ours its view and unit as well: options that
/// choose them are refused, as the window's dialog has their fields off.
/// @throw ArgumentError  naming the option
void requireUseOfMapOptions(const MapArguments& arguments, const Surface& surface);

}  // namespace relievo::batch
