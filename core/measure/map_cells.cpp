// SPDX-License-Identifier: BSD-3-Clause
#include "core/measure/map_cells.h"

#include <utility>

namespace relievo {

MapPart::MapPart(const DepthMap& map)
    : frame_(map.frame),
      cells_(map.frame.size),
      heights_mm_(map.heights_mm.data()),
      origins_(map.origins.data()) {}

MapPart::MapPart(const GridFrame& frame, Cell first, DepthMap cells)
    : frame_(frame),
      first_(first),
      cells_(cells.frame.size),
      own_(std::move(cells)),
      heights_mm_(own_.heights_mm.data()),
      origins_(own_.origins.data()) {}

MapCells::MapCells(const DepthMap& map)
    : frame_(map.frame), read_([&map](Cell, GridSize) { return MapPart(map); }) {}

MapCells::MapCells(const GridFrame& frame, ReadPart read) : frame_(frame), read_(std::move(read)) {}

}  // namespace relievo
