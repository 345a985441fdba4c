// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "core/base/vec3.h"
#include "core/project/project.h"
#include "core/region/region.h"

namespace relievo {

/// The name of the place that a hand is at: of those whose centre is within its reach, or whose
/// window it is in the middle of, the one with the nearest centre; empty: of none. A window of more
/// than half of the object's longer side is a view of it, and no place.
std::string nameAt(const std::vector<NamedRegion>& places, const RectMm& object, const ViewMm& at,
                   double reach_mm);

}  // namespace relievo
