// SPDX-License-Identifier: BSD-3-Clause
#include "core/prepare/crop.h"

#include <algorithm>

namespace relievo {
namespace {

constexpr std::uint8_t kLowNoise = 7, kHighNoise = 18;  // LAS 1.4, table 17.

FilePoint along(const Rotation& axes, const FilePoint& p) noexcept {
  return {axes[0] * p.x + axes[1] * p.y + axes[2] * p.z,
          axes[3] * p.x + axes[4] * p.y + axes[5] * p.z,
          axes[6] * p.x + axes[7] * p.y + axes[8] * p.z};
}

}  // namespace

bool keeps(const CropBox& step, const FilePoint& p) noexcept {
  const FilePoint q = along(step.axes, p);
  const bool inside = q.x >= step.min.x && q.x <= step.max.x && q.y >= step.min.y &&
                      q.y <= step.max.y && q.z >= step.min.z && q.z <= step.max.z;
  return inside == step.keep_inside;
}

bool keeps(const CropOutline& step, const FilePoint& p) noexcept {
  const FilePoint q = along(step.view, p);
  bool inside = false;
  auto last = step.outline.back();
  for (const auto& corner : step.outline) {
    // Half open in y, so that a corner on the ray counts for one of its two edges.
    const bool crosses = (corner[1] > q.y) != (last[1] > q.y);
    if (crosses) {
      const double share = (q.y - last[1]) / (corner[1] - last[1]);
      if (q.x < last[0] + share * (corner[0] - last[0])) inside = !inside;
    }
    last = corner;
  }
  return inside == step.keep_inside;
}

bool keeps(const Classes& step, std::uint8_t class_of_point) noexcept {
  const bool named =
      std::find(step.keep.begin(), step.keep.end(), class_of_point) != step.keep.end();
  if (named) return true;
  if (!step.keep.empty()) return false;
  return step.keep_noise || (class_of_point != kLowNoise && class_of_point != kHighNoise);
}

bool keeps(const Returns& step, std::uint8_t packed) noexcept {
  const unsigned number = packed & 15U, of = packed >> 4U;
  switch (step.keep) {
    case ReturnChoice::first:
      return number <= 1;
    case ReturnChoice::last:
      return number >= of;
    case ReturnChoice::single:
      return of <= 1;
  }
  return true;
}

}  // namespace relievo
