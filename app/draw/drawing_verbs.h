// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "app/cli/drawing.h"

namespace relievo::batch {

Verb renderVerb();
Verb figureVerb();
Verb videoVerb();

/// All that a program needs to draw by itself; for `setDrawing`.
Drawing ownDrawing();

}  // namespace relievo::batch
