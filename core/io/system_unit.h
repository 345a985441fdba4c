// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string_view>

#include "core/cloud/scan.h"
#include "core/io/las_header.h"

namespace relievo {

/// A LAS file may name its coordinate system (EPSG code) and no unit. Then the unit comes from the
/// registry that PROJ has installed, into `info`; a warning says so where that does not help.
/// Needs GDAL, so that it is asked by the parent of the import worker. [worker]
/// @param head  the file's header and records
/// @return  what heights are to be multiplied by, see readLasUnit; 1 where `info` has a unit
/// already
double addUnitOfSystem(std::string_view head, const LasHeader& header, ScanInfo& info);

/// The same for a file that was read. @throw FileError  it has gone, or has another header by now
double addUnitOfSystem(const std::filesystem::path& file, ScanInfo& info);

}  // namespace relievo
