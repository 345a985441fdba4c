// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>

#include "tests/fuzz/mutation.h"

namespace relievo::fuzz {

/// Changes one entry of a little-endian TIFF's first directory, what it points at, or the list of
/// entries; longer contents go to the end of the file. @return  false if it is no such file
bool mutateTiff(std::string& file, Chance& chance);

}  // namespace relievo::fuzz
