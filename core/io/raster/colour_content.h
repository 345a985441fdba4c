// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Only for the .cpp files of core/io that write and read the colours beside a map: what these files
// say of themselves.
#include <string_view>

namespace relievo {

inline constexpr std::string_view kColours = "colours";          ///< RELIEVO_CONTENT of colours,
inline constexpr std::string_view kIntensities = "intensities";  ///< and of intensities.
inline constexpr const char* kColoursOf = "RELIEVO_HEIGHTS";     ///< heightsChecksum of the map.

}  // namespace relievo
