// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>

#include "core/base/error.h"

namespace relievo {

/// A recording (E401) that could not be begun, and of which nothing is left.
/// @param why  an errno; 0: the HDF5 library
WriteError recordingRefused(const std::filesystem::path& file, int why);

/// A recording (E401) that is whole up to where it stopped. @param why  as above
WriteError recordingStopped(const std::filesystem::path& file, int why, std::uint64_t rows);

}  // namespace relievo
