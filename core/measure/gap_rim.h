// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/measure/map_cells.h"

namespace relievo {

/// How far the measured heights around a gap are from the height that was made for one of its
/// cells: the most of those that are met first in eight directions (docs/adr/0149). 0 for a cell
/// that is not interpolated, and where none is met within 512 cells. @throw what `map` throws
double gapRimMm(const MapCells& map, Cell cell);

}  // namespace relievo
