// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "core/base/grid.h"

namespace relievo {

/// Bytes that a depth map of this size and its pyramid take at the most crowded moment of their
/// making; the scan itself is in memory already.
std::uint64_t surfaceBytes(GridSize size);

/// Bytes more for what a scan says of colours and intensities (core/depth/colours/colours.h).
std::uint64_t colourBytes(GridSize size, bool scan_colours, bool scan_intensities);

/// Bytes that can be had without swapping: of the machine, or of the control group that the process
/// is in (a container, a batch job, a limited desktop session) where that leaves less; nothing
/// where the system does not say. What a group keeps only to read files faster counts as free. [any
/// thread]
/// @param root  where /proc and /sys are found
std::optional<std::uint64_t> availableBytes(const std::filesystem::path& root = "/");

/// To be asked before the work.
/// @param colour_bytes  of colourBytes
/// @throw ArgumentError  E102, with the spacing that would fit
void requireMemory(const GridFrame& frame, std::optional<std::uint64_t> available,
                   std::uint64_t colour_bytes = 0);

}  // namespace relievo
