// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/task.h"
#include "core/base/transform.h"
#include "core/cloud/scan.h"

namespace relievo {

/// Rotation file -> view, 3 x 3 row-major, determinant +1: row 0 is view x in file axes.
using Rotation = std::array<double, 9>;

/// From where the object is seen. A free view carries its own rotation.
struct ViewChoice {
  std::string name;                  ///< top bottom front back left right auto free
  std::optional<Rotation> rotation;  ///< For "free".
};

/// Rotation of one of the six standard views: top: x, y, z. bottom: x, -y, -z. front: x, z, -y.
/// back: -x, z, y. right: y, z, x. left: -y, z, -x. Nothing for other names.
std::optional<Rotation> standardRotation(std::string_view name);

struct NamedRotation {
  std::string name;
  Rotation rotation;
};
/// The standard view from which the object shows most of itself: face towards me. [worker]
/// Chooses the direction along which the scan is thinnest, and of the two sides the one on which
/// more of the surface is in front.
NamedRotation automaticRotation(const Scan& scan, const Task& task = {});

/// Box of the scan after rotation and scaling to mm, no translation.
struct RotatedBounds {
  ViewMm min, max;
};
RotatedBounds rotatedBounds(const Scan& scan, const Rotation& rotation, double mm_per_unit);

}  // namespace relievo
