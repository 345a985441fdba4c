// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "core/base/task.h"

namespace relievo {

/// Pixels of a picture as its file stores them.
struct StoredPixels {
  int width = 0, height = 0, channels = 3;  ///< Four: the last is alpha, colours not multiplied.
  std::vector<std::uint8_t> bytes;          ///< Row 0 at the top.
};

/// Of a PNG or TIFF of 8 bits a channel in red, green and blue, with alpha or without; nothing: the
/// file is none, or it is damaged. An import process reads it. [any thread]
/// @throw FileError  missing, or larger than an import may be; Cancelled
std::optional<StoredPixels> importPixels(const std::filesystem::path& file, const Task& task = {});

/// The same, in this process, through GDAL. [worker process]
std::optional<StoredPixels> readPixelsHere(const std::filesystem::path& file);

}  // namespace relievo
