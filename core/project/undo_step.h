// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/measure/measure.h"
#include "core/project/named_region.h"

namespace relievo {

struct Project;

/// What leads from a list back to the one before: `gone` of its entries, from the one at `at`, make
/// place for `back`.
template <class T>
struct ListChange {
  std::size_t at = 0;
  std::size_t gone = 0;
  std::vector<T> back;
  friend bool operator==(const ListChange&, const ListChange&) = default;
};

/// A step of the work as files keep it: what it changed, as it was before. Steps that made the
/// surface anew have none, because their surface would have to be made again.
struct UndoStep {
  /// Its name, and the window before; the view where light, relief image, stereo or turn changed.
  NamedRegion before;
  /// Only with a view, as Project has it.
  std::optional<double> chosen_eye_angle_deg = std::nullopt;
  std::optional<ListChange<NamedRegion>> places = std::nullopt;
  std::optional<ListChange<Measurement>> measurements = std::nullopt;
  friend bool operator==(const UndoStep&, const UndoStep&) = default;
};

/// What leads from `after` back to `before`, which differ in nothing but window, view, places and
/// measurements.
UndoStep undoStep(std::string name, const Project& before, const Project& after);

/// @return false, and `project` is left as it was: the step does not fit it
bool takeBack(const UndoStep& step, Project& project);

}  // namespace relievo
