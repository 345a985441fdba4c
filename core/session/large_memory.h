// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/base/grid.h"
#include "core/session/large_map.h"

namespace relievo {

/// How the budget of a map by tiles is divided. The stages follow each other, so that each may use
/// what the other gave back.
struct MemoryPlan {
  std::size_t points_bytes = 0;  ///< For TileStore.
  std::size_t depths_bytes = 0;  ///< For depths between the stages.
};

/// To be asked before the work. @throw ArgumentError  E102, with what would do
MemoryPlan planMemory(const GridFrame& frame, const LargeMapOptions& large);

}  // namespace relievo
