// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "data/generate/solid.h"

namespace relievo::samples {

/// Who rides across the panel, in millimetres of the panel: trees and leaves behind, a horse and
/// its rider, in front an elephant with driver and parasol.
std::vector<Figure> panelFigures();

}  // namespace relievo::samples
