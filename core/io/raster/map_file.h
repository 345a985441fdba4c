// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Only for the .cpp files of core/io and core/tiles that read and write maps: how a map's files say
// what they are.
#include <filesystem>
#include <limits>
#include <string_view>

namespace relievo {

inline constexpr std::string_view kOriginContent =
    "origins";  ///< RELIEVO_CONTENT of NAME.origin.tif.

/// What a map's file has in cells without a height.
inline constexpr float kNoHeight = std::numeric_limits<float>::quiet_NaN();

/// Holds the state a file was made with (MapFileOptions::state).
inline constexpr const char* kDescriptionTag = "TIFFTAG_IMAGEDESCRIPTION";

/// The coordinates of maps in view mm, for programs that ask in which unit a raster is.
inline constexpr const char* kViewSystem =
    R"(LOCAL_CS["view millimetres",UNIT["millimetre",0.001],AXIS["x",EAST],AXIS["y",NORTH]])";

/// NAME.origin.tif beside NAME.tif.
inline std::filesystem::path originFileOf(std::filesystem::path map_file) {
  return map_file.replace_extension(".origin.tif");
}

}  // namespace relievo
