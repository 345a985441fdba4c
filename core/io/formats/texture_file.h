// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "core/cloud/scan.h"

namespace relievo {

/// A picture of a mesh from a PNG, JPEG or TIFF file, through GDAL. Its sides are looked at before
/// a texel is decoded: a JPEG of 200 kB may hold 30 000 x 30 000.
/// @param most_texels  that there is room for
/// @param reason  why there is none, behind "FILE, which it names, ": given wherever nothing is
/// returned
std::optional<Texture> readTexture(const std::filesystem::path& file, std::uint64_t most_texels,
                                   std::optional<Message>& reason);

}  // namespace relievo
