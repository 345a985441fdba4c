// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "core/io/las/laz_file.h"

namespace relievo {

/// Chunks of a file whose list of chunks is missing, found one after the other: layered ones say
/// how long they are; others are unpacked to learn where they end, on this thread. [any thread]
/// @param start         byte of the first chunk
/// @param chunk_points  of each; 0 where they are of any number, which only layered ones tell
/// @param promised      points of the whole file; there are no more
/// @return  those that are whole, and of the chunk that is cut the points before the cut if the
///          records are not layered. They are neither copied nor kept.
std::vector<LazChunk> findLazChunks(const LazBytesSource& source, const LazLayout& layout,
                                    std::uint64_t start, std::uint32_t chunk_points,
                                    std::uint64_t promised);

}  // namespace relievo
