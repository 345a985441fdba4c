// SPDX-License-Identifier: BSD-3-Clause
#include "app/draw/hand_back.h"

#include <cstdio>

#include "app/cli/verb.h"
#include "core/base/error.h"
#include "core/io/raster/picture_pixels.h"

namespace relievo {

namespace {
std::optional<StoredPixels> pixelsOf(const std::filesystem::path& picture) {
  try {
    return importPixels(picture);
  } catch (const FileError&) {  // Whoever asked is told below, as of any other file.
    return std::nullopt;
  }
}
}  // namespace

int handBackPixels(const std::filesystem::path& picture) {
  const std::optional<StoredPixels> pixels = pixelsOf(picture);
  if (!pixels) {
    batch::tell(picture.filename().string() + " is no picture that relievo drew.");
    return 2;
  }
  const int head = std::printf("%d %d %d\n", pixels->width, pixels->height, pixels->channels);
  const std::size_t written = std::fwrite(pixels->bytes.data(), 1, pixels->bytes.size(), stdout);
  const bool whole = head > 0 && written == pixels->bytes.size() && std::fflush(stdout) == 0;
  if (!whole) batch::tell("The pixels could not be written to standard output.");
  return whole ? 0 : 3;
}

}  // namespace relievo
