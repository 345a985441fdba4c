// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

#include "core/cloud/scan.h"
#include "core/io/las_header.h"

namespace relievo {

/// Finds the unit of the coordinates in the variable length records (GeoTIFF keys or well-known
/// text) and puts it into `info`, with warnings about degrees and about heights in another unit.
/// Records that are cut or make no sense say nothing.
void readLasUnit(std::string_view bytes, const LasHeader& header, ScanInfo& info);

}  // namespace relievo
