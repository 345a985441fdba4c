// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/depth/view.h"

namespace relievo {

/// How much of the object is seen from one side: larger is more; only compared. Depends on the
/// direction of sight alone, not on what is up. [worker]
double shownFrom(const Scan& scan, const Rotation& rotation);

/// Of the six standard views the one that shows most. [worker]
/// Chooses the direction along which the scan is thinnest, and of the two sides the one on which
/// more of the surface is in front.
NamedRotation automaticFace(const Scan& scan, const Task& task = {});

}  // namespace relievo
