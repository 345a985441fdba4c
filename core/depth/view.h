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
  std::string name;                  ///< One of `kViewNames`, or "free".
  std::optional<Rotation> rotation;  ///< For "free".
  /// Then turned about the view's own x, y and z axis, in this order; right-handed, degrees.
  std::array<double, 3> turn_deg{};
};

/// auto: the standard view that shows most. fit: along the normal of the best-fit plane, the file's
/// axes as upright as they can be. axes: the longest principal axis to the right, the shortest
/// toward the viewer.
inline constexpr std::array<std::string_view, 9> kViewNames{
    "front", "back", "left", "right", "top", "bottom", "auto", "fit", "axes"};

/// Rotation of one of the six standard views: top: x, y, z. bottom: x, -y, -z. front: x, z, -y.
/// back: -x, z, y. right: y, z, x. left: -y, z, -x. Nothing for other names.
std::optional<Rotation> standardRotation(std::string_view name);

struct NamedRotation {
  std::string name;
  Rotation rotation;
  std::string note{};  ///< For people, if the choice was not certain; else empty.
};
/// The standard view from which the object shows most of itself: face towards me. [worker]
/// Chooses the direction along which the scan is thinnest, and of the two sides the one on which
/// more of the surface is in front.
NamedRotation automaticRotation(const Scan& scan, const Task& task = {});

/// The rotation that a choice names, turned as it says: name "fit + 0, 10, 0 degrees". [worker]
/// @throw ArgumentError  no such view, a free view without a rotation, or a turn that is not finite
NamedRotation chosenRotation(const Scan& scan, const ViewChoice& choice, const Task& task = {});

/// Turns a view about its own x, then y, then z axis; right-handed, degrees.
Rotation turned(const Rotation& rotation, const std::array<double, 3>& turn_deg);

/// Box of the scan after rotation and scaling to mm, no translation.
struct RotatedBounds {
  ViewMm min, max;
};
RotatedBounds rotatedBounds(const Scan& scan, const Rotation& rotation, double mm_per_unit);

}  // namespace relievo
