// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "core/region/region.h"

namespace relievo {

/// Sides on which the region is at the map's edge, where moved() goes no further: 1 left, 2 right,
/// 4 down, 8 up.
std::uint8_t edgesOf(const DetailLadder& ladder, const Region& region);

}  // namespace relievo
