// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/base/unit.h"
#include "core/cloud/scan.h"

namespace relievo {

/// The unit that a scan without one most likely has, from its size alone: a coin, a relief or a
/// statue is between 5 mm and 20 m long. Only ever offered, never used unasked.
LengthUnit guessedUnit(const FileBounds& bounds);

}  // namespace relievo
