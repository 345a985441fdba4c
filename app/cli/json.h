// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Only for the .cpp files of app/cli: what several reports share.
#include <nlohmann/json.hpp>

#include "core/base/transform.h"
#include "core/measure/measure.h"
#include "core/region/region.h"

namespace relievo::batch {

using Json = nlohmann::ordered_json;

template <class To, class From>
Json jsonOf(const Transform<To, From>& transform) {
  return Json(transform.m);
}

/// @pre hasPlane(m.kind)
inline Json planeJson(const Measurement& m) {
  return Json{m.normal.x, m.normal.y, m.normal.z, m.plane_mm};
}

inline Json jsonOf(const Region& region) {
  return Json{region.x_mm, region.y_mm, region.side_mm, region.side_mm};
}

}  // namespace relievo::batch
