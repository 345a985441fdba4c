// SPDX-License-Identifier: BSD-3-Clause
// Asks the import process, and is therefore apart from tiff_head.cpp, which runs in it.
#include <system_error>

#include "core/base/error.h"
#include "core/base/failure.h"
#include "core/io/raster/raster.h"
#include "core/io/raster/tiff_head.h"

namespace relievo {

std::optional<std::string> rasterState(const std::filesystem::path& file) {
  return descriptionIn(importTiffHead(file), file);
}

bool isOwnTiff(const std::filesystem::path& file) {
  try {
    const auto head = importTiffHead(file);
    return head && head->facts.contains("RELIEVO_VERSION");
  } catch (const FileError&) {  // Whatever it is, it is none of ours.
    return false;
  }
}

void requireOwnOrAbsent(const std::filesystem::path& file) {
  std::error_code unknown;
  const bool is_there = std::filesystem::exists(std::filesystem::symlink_status(file, unknown));
  if (!is_there || isOwnTiff(file)) return;
  throw failure<MessageId::file_is_of_another_program>(file);
}

}  // namespace relievo
