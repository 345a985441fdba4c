// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/provenance/libraries.h"

namespace relievo::batch {

/// Of all libraries that this program uses, by name: core's, those of packages and devices, and in
/// the program that draws those of pictures.
std::vector<LibraryVersion> libraryVersions();

}  // namespace relievo::batch
