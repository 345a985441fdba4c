// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "core/region/window.h"
#include "core/relief/look.h"
#include "core/relief/stereo.h"
#include "core/session/large/crop_level.h"
#include "core/session/surface.h"

namespace relievo {

// A scan's own colours, to be drawn: the counterparts of windowOf, windowMap and cropLevel, in
// memory and by tiles. Empty where the scan has none.

/// @param ring  as windowMap [any thread]
GridColours windowColours(const Surface& surface, const RegionWindow& window, int ring = 0);

/// As cropLevel; samples whose nearest cell is a hole have none, and of those outside only the
/// ones beside the object. [any thread]
/// @pre within the level
GridColours levelColours(const Surface& surface, Level level, const LevelSamples& samples);
GridColours levelColours(const Surface& surface, Level level);

/// How many cells have a colour of their own.
struct OwnCells {
  std::size_t measured = 0, own = 0;
};
/// What is said of a map with colours, or intensities.
Message colourWords(const OwnCells& cells);
Message intensityWords(const OwnCells& cells, const IntensityRange& shown);

/// Whose colours cells get whose heights were made so. @param rule  Surface::rule, whose end is the
/// rule's name
ColourRule colourRuleOf(const std::string& rule);

/// Gives a surface with heights and levels the colours of the scan it was made from, and says so.
/// [worker] @throw Cancelled
void addColours(Surface& surface, const Scan& scan, const Task& task);
/// The same with those of a map that was read. [worker] @throw Cancelled
void addColours(Surface& surface, GridColours&& finest, const Task& task);

/// Of the finest level in memory; none of maps by tiles.
GridColours finestColours(const Surface& surface);

/// Share of a window that one eye sees dark through red and cyan glasses; 0 where the look or the
/// way of mixing shows no colours. [any thread] @throw FileError
double rivalShare(const Surface& surface, const RegionWindow& window, ReliefKind kind,
                  StereoPrint print);
/// The warning; empty if the share is small.
std::string rivalryWords(double share);

/// Can the surface be seen so? All looks but natural and intensity can always.
bool canShow(const Surface& surface, ReliefKind kind);

/// @throw ArgumentError  it cannot: the scan says nothing of what the look shows
void requireColours(const Surface& surface, ReliefKind kind);

}  // namespace relievo
