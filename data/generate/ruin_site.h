// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace relievo::samples {

/// Height of the ruin's surface in metres above the lowest ground, at metres east and north of the
/// site's south-west corner.
double siteHeightM(double east, double north);

/// Did no scan return anything there: water in the tank, thicket?
bool siteUnseen(double east, double north);

}  // namespace relievo::samples
