// SPDX-License-Identifier: BSD-3-Clause
#include "core/measure/map_cells.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace relievo {

MapPart::MapPart(const DepthMap& map, const HeightErrors& errors)
    : frame_(map.frame),
      cells_(map.frame.size),
      errors_(errors),
      heights_mm_(map.heights_mm.data()),
      origins_(map.origins.data()) {}

MapPart::MapPart(const GridFrame& frame, Cell first, DepthMap cells)
    : frame_(frame),
      first_(first),
      cells_(cells.frame.size),
      own_(std::move(cells)),
      heights_mm_(own_.heights_mm.data()),
      origins_(own_.origins.data()) {}

double MapPart::heightErrorMm(Cell c) const noexcept {
  // Files hold coordinates in single precision: a relative error of 2^-24 of the object's size.
  const double size_mm = frame_.spacing_mm * std::max(frame_.size.cols, frame_.size.rows);
  double off = std::max(0.5 * errors_.step_mm, std::ldexp(size_mm, -24));
  if (errors_.quality != nullptr) {
    const std::size_t i = index(c);
    const auto spread = static_cast<double>(errors_.quality->spreads_mm[i]);
    const double points = std::max<double>(errors_.quality->counts[i], 1);
    off += 2 * (errors_.of_one_point ? spread : spread / std::sqrt(points));
  }
  return off;
}

MapCells::MapCells(const DepthMap& map, const HeightErrors& errors)
    : frame_(map.frame), read_([&map, errors](Cell, GridSize) { return MapPart(map, errors); }) {}

MapCells::MapCells(const GridFrame& frame, ReadPart read) : frame_(frame), read_(std::move(read)) {}

}  // namespace relievo
