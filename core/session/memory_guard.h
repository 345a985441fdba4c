// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>

#include "core/base/grid.h"

namespace relievo {

/// Bytes that a depth map of this size and its pyramid take at the most crowded moment of their
/// making; the scan itself is in memory already.
std::uint64_t surfaceBytes(GridSize size);

/// Bytes that can be had without swapping; nothing where the system does not say.
std::optional<std::uint64_t> availableBytes();

/// To be asked before the work.
/// @throw ArgumentError  E102, with the spacing that would fit
void requireMemory(const GridFrame& frame, std::optional<std::uint64_t> available);

}  // namespace relievo
