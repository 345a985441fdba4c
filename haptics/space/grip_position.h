// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "core/base/vec3.h"
#include "haptics/rt/realtime.h"
#include "haptics/space/workspace.h"

namespace relievo {

/// How the device stands before the person, and so which way its grip is pushed to press into the
/// relief. Its own axes are x right, y up, z out of it, toward who stands before it.
enum class GripPosition : std::uint8_t {
  upright,  ///< Before the person: the relief stands like a picture, and is pressed away from one.
  flat,     ///< The same device; the relief lies like a sheet on a table, and is pressed down.
  left,     ///< At the person's left, turned to the right; the relief stands before the person.
  right,    ///< At the person's right, turned to the left; the relief stands before the person.
};

/// Words of options, settings and recordings, in the order of the positions.
inline constexpr std::array<std::string_view, 4> kGripPositionNames{"upright", "flat", "left",
                                                                    "right"};

constexpr std::string_view name(GripPosition position) {
  return kGripPositionNames[static_cast<std::size_t>(position)];
}

/// Nothing: no position of that name.
constexpr std::optional<GripPosition> gripPosition(std::string_view name) {
  for (std::size_t i = 0; i < kGripPositionNames.size(); ++i) {
    if (kGripPositionNames[i] == name) return static_cast<GripPosition>(i);
  }
  return std::nullopt;
}

/// A place or a force in the device's own axes, as the hand meets the relief: x right along it, y
/// up along it, z out of it. A turn by right angles, so that no digit is lost.
template <class Tag>
constexpr Vec3<Tag> handFromDevice(GripPosition position, Vec3<Tag> v) RELIEVO_REALTIME {
  switch (position) {
    case GripPosition::upright:
      break;
    case GripPosition::flat:
      return {v.x, -v.z, v.y};
    case GripPosition::left:
      return {v.z, v.y, -v.x};
    case GripPosition::right:
      return {-v.z, v.y, v.x};
  }
  return v;
}

/// The way back.
template <class Tag>
constexpr Vec3<Tag> deviceFromHand(GripPosition position, Vec3<Tag> v) RELIEVO_REALTIME {
  switch (position) {
    case GripPosition::upright:
      break;
    case GripPosition::flat:
      return {v.x, v.z, -v.y};
    case GripPosition::left:
      return {-v.z, v.y, v.x};
    case GripPosition::right:
      return {v.z, v.y, -v.x};
  }
  return v;
}

/// How far the hand reaches along the relief and out of it.
inline Workspace handFromDevice(GripPosition position, const Workspace& device) RELIEVO_REALTIME {
  const DeviceMm turned = handFromDevice(position, device.half_extent);
  return {{std::abs(turned.x), std::abs(turned.y), std::abs(turned.z)}};
}

}  // namespace relievo
