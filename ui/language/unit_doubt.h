// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QString>
#include <vector>

#include "core/session/surface.h"

namespace relievo {

/// Units that a scan may be meant in, the commonest first: fewer where its file says one, those of
/// maps where its coordinates are a map's.
std::vector<LengthUnit> unitsToOffer(const Surface& surface);
/// The box in numbers of the file, without a unit. @pre surface.info.bounds
QString unitlessSize(const Surface& surface);
/// The box in each of these units. @pre surface.info.bounds
QString sizesInUnits(const Surface& surface, const std::vector<LengthUnit>& units);
/// What is told of a unit that no file and nobody said. @pre it was assumed or guessed
QString unitDoubt(const Surface& surface);

}  // namespace relievo
