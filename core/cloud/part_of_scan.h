// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "core/cloud/scan.h"

namespace relievo {

/// The points with keep[i] != 0, the triangles all of whose corners are kept, and what the file
/// says of each. `info` is that of the whole but for the box, which lies around what is kept.
/// @pre keep is as long as scan.points and keeps at least one  [worker]
Scan partOf(const Scan& scan, const std::vector<std::uint8_t>& keep);

}  // namespace relievo
