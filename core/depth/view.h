// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/task.h"
#include "core/base/transform.h"
#include "core/cloud/scan.h"
#include "core/message/message.h"

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

/// auto: upright, and from where it shows most. fit: along the normal of the best-fit plane, the
/// file's axes as upright as they can be. axes: the longest principal axis to the right, the
/// shortest toward the viewer.
inline constexpr std::array<std::string_view, 9> kViewNames{
    "front", "back", "left", "right", "top", "bottom", "auto", "fit", "axes"};

/// Rotation of one of the six standard views: top: x, y, z. bottom: x, -y, -z. front: x, z, -y.
/// back: -x, z, y. right: y, z, x. left: -y, z, -x. Nothing for other names.
std::optional<Rotation> standardRotation(std::string_view name);

/// The same of the 24 rotations that lay the file's axes along the view's: the six, and each turned
/// about the line of sight: "back, turned to the left", "back, turned to the right", "back, upside
/// down".
std::optional<Rotation> namedRotation(std::string_view name);
/// The name that namedRotation knows it by; "free" for others.
std::string nameOf(const Rotation& rotation);

struct NamedRotation {
  std::string name;
  Rotation rotation;
  std::optional<Message> note{};  ///< If the choice was not certain.
  bool is_weak = false;           ///< Chosen automatically, and another may well be right.
};
/// Of the 24 rotations the one in which the object stands upright and shows most of itself: face
/// towards me. [worker] (docs/adr/0101-objects-stand-up.md)
NamedRotation automaticRotation(const Scan& scan, const Task& task = {});

/// What `auto` was before objects stood up: one of the six. Older projects mean it; not offered.
inline constexpr std::string_view kEarlierAutomatic = "face";

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
