// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/cloud/scan.h"
#include "core/depth/rules/cell_size.h"
#include "core/depth/view.h"
#include "core/session/surface.h"

namespace relievo {

// What is chosen between a file and its surface, the same for maps in memory and for tiled ones.
// Each says in surface.messages what it chose unasked.

/// What there is to say, if there is something.
void say(std::vector<Message>& messages, std::optional<Message> message);
void say(std::vector<Message>& messages, std::vector<Message> more);

/// surface.unit and where it is from. @pre surface.info
void chooseUnit(Surface& surface, const SurfaceOptions& options);

/// Keeps it, and says it where nobody did. @pre chooseUnit
void sayScale(Surface& surface, const ScaleInUse& scale);

/// Of ViewFromFile::m, of a view from the top: view mm in a step of the file's heights.
inline constexpr std::size_t kHeightScale = 10;

/// Where a map is kept while it is made: it limits how many cells there can be.
enum class MapPlace {
  memory,  ///< 16384^2 cells, 1 GiB of heights.
  tiles,   ///< 2^40 cells, and 2^23 a side: 10^6 x 10^6, say, if the disk has room.
};

/// Samples so that the first and last lie on the box; the map's lower left edge becomes (0, 0).
/// @param propose  how many cells the points carry, asked if the options leave it open
/// @throw ArgumentError, FileError
GridFrame chooseFrame(Surface& surface, const SurfaceOptions& options, const RotatedBounds& box,
                      const std::function<CellProposal()>& propose,
                      MapPlace place = MapPlace::memory);

/// Rotation, scaling to millimetres, then a shift.
ViewFromFile viewFromFile(const Rotation& rotation, double mm_per_unit, double dx, double dy,
                          double dz);

}  // namespace relievo
