// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/region/region.h"

namespace relievo {

/// Standard deviation sigma, on the object, of the Gaussian by which a level is smoother than the
/// map it was made of: the kernels of all steps together. 0 for the finest.
/// @pre a level of the ladder
double smoothingMm(const DetailLadder& ladder, Level level);

}  // namespace relievo
