// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

namespace relievo {

/// The first word of `relievo-draw pixels-VERSION PICTURE`, between two parts of one version.
inline constexpr const char* kPixelsArgument = "pixels-" RELIEVO_VERSION_STRING;

/// Writes to standard output what a picture holds that this program drew: a line "WIDTH HEIGHT
/// CHANNELS", then the pixels, a byte for each channel, row 0 at the top. So that whoever asked for
/// a picture parses none (docs/adr/0148).
/// @return exit code: 0; 2: no picture of ours; 3: they cannot be written
int handBackPixels(const std::filesystem::path& picture);

}  // namespace relievo
