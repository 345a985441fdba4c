// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QString>
#include <vector>

#include "core/prepare/recipe.h"

namespace relievo {

/// "Outliers, statistical": what a step is called in the window.
QString nameOfStep(const Step& step);
/// The same with its numbers: "Outliers, statistical: 8, 2". One line.
QString wordsOfStep(const Step& step);

/// A step that can be added, with values that suit most scans.
struct OfferedStep {
  QString text;  ///< With a mnemonic.
  std::vector<Step> steps;
};
/// @param box     what is left, file units: where a box to crop to begins
/// @param unit    of the scans  @param spacing  of their points, file units
std::vector<OfferedStep> offeredSteps(const FileBounds& box, LengthUnit unit, double spacing);

}  // namespace relievo
