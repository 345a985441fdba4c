// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/cloud/scan.h"
#include "core/io/las/las_unit.h"

namespace relievo {

/// A LAS file may name its coordinate system (EPSG code) and no unit. Then the unit comes from the
/// registry that PROJ has installed, into `info`; a warning says so where that does not help.
/// Needs GDAL, so that it is asked by the parent of the import process, which is told the code.
/// [worker]
/// @return  what heights are to be multiplied by, see readLasUnit
double addUnitOfSystem(const LasSystem& named, ScanInfo& info);

}  // namespace relievo
