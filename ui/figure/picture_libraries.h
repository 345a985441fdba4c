// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/provenance/libraries.h"

namespace relievo {

/// Those that decide the pixels of pictures and figures, by name, as this process has loaded them.
std::vector<LibraryVersion> pictureLibraries();

}  // namespace relievo
