// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/provenance/libraries.h"

namespace relievo::batch {

/// Of all libraries that the command line uses, by name: core's, and those of pictures, packages
/// and devices.
std::vector<LibraryVersion> libraryVersions();

}  // namespace relievo::batch
