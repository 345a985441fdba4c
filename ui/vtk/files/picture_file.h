// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/file/atomic_file.h"
#include "ui/vtk/offscreen.h"

namespace relievo {

using PictureText = std::vector<std::pair<std::string, std::string>>;

/// The entry that holds the project, from which a picture's state comes back
/// (core/provenance/embedded.h reads it).
inline constexpr const char* kStateEntry = "relievo:state";

/// Dots per inch of what is for screens: a TIFF must say some.
inline constexpr double kScreenDpi = 96;

enum class PictureFormat { png, tiff };
/// By the name's ending: .png .tif .tiff
std::optional<PictureFormat> pictureFormatOf(const std::filesystem::path& file);

/// PNG, RGB where every pixel is opaque and RGBA else, with its density and text entries (Title,
/// Software, relievo:state, ...). Written beside the target and renamed. @throw WriteError
void writePng(const OutputFile& file, const RgbaImage& image, double dpi, const PictureText& text);

/// TIFF, packed without loss, with density; the entries Description and relievo:state stand in the
/// tag ImageDescription, Software in its own. @throw WriteError
void writeTiff(const OutputFile& file, const RgbaImage& image, double dpi, const PictureText& text);

struct GreyPicture {
  int width = 0, height = 0;
  std::vector<std::uint16_t> values;  ///< Row 0 at the top.
};
/// 16-bit grey. @throw WriteError
void writeTiff(const OutputFile& file, const GreyPicture& image, double dpi,
               const PictureText& text);

}  // namespace relievo
