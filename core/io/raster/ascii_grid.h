// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>

namespace relievo {

/// GDAL gives the last missing cell of a cut ESRI ASCII grid a value; so cells are counted first.
/// @throw FileError  the file holds fewer than `promised` cells
void checkAsciiGridCells(const std::filesystem::path& file, std::uint64_t promised);

}  // namespace relievo
