// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/region/window.h"
#include "core/relief/look.h"
#include "core/session/level_cut.h"
#include "core/session/surface.h"

namespace relievo {

// A scan's own colours, to be drawn: the counterparts of windowOf, windowMap and levelCut. Empty
// where the scan has none, and of maps by tiles, whose files hold heights only.

/// @param ring  as windowMap [any thread]
GridColours windowColours(const Surface& surface, const RegionWindow& window, int ring = 0);

/// As levelCut; samples whose nearest cell is a hole have none, and of those outside only the
/// ones beside the object. [any thread]
/// @pre within the level
GridColours levelColours(const Surface& surface, Level level, const LevelSamples& samples);
GridColours levelColours(const Surface& surface, Level level);

/// Gives a surface with heights and levels the colours of the scan it was made from, and says so.
/// [worker] @throw Cancelled
void addColours(Surface& surface, const Scan& scan, const Task& task);
/// The same with those of a map that was read. [worker] @throw Cancelled
void addColours(Surface& surface, GridColours&& finest, const Task& task);

/// Can the surface be seen so? All looks but natural and intensity can always.
bool canShow(const Surface& surface, ReliefKind kind);

/// @throw ArgumentError  it cannot: the scan says nothing of what the look shows
void requireColours(const Surface& surface, ReliefKind kind);

}  // namespace relievo
