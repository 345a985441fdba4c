// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

#include "core/cloud/scan.h"
#include "core/io/las_header.h"

namespace relievo {

inline constexpr std::size_t kLasHeadBytes = 1 << 20;  ///< Header and records that name a unit.

/// Finds the unit of the coordinates in the variable length records (GeoTIFF keys or well-known
/// text) and puts it into `info`, with warnings about degrees, about units that are not known here
/// and about heights in another unit.
/// Records that are cut or make no sense say nothing.
void readLasUnit(std::string_view bytes, const LasHeader& header, ScanInfo& info);

/// Warns of heights in another unit than `info.unit`, if the records state theirs; readLasUnit did
/// where they state both.
void warnOfHeights(std::string_view bytes, const LasHeader& header, ScanInfo& info);

/// EPSG code of the projected system, if the file names it but not its unit.
std::optional<int> lasSystem(std::string_view bytes, const LasHeader& header);

}  // namespace relievo
