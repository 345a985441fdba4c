// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "app/cli/drawing.h"

namespace relievo::batch {

Verb renderVerb();
Verb figureVerb();
Verb videoVerb();

/// @throw ArgumentError  a picture's name must end in .png, .tif or .tiff
void requirePictureName(const std::string& file);

/// All that a program needs to draw by itself; for `setDrawing`.
Drawing ownDrawing();

}  // namespace relievo::batch
