// SPDX-License-Identifier: BSD-3-Clause
#include "app/draw/hand_back.h"

#include <cstdio>

#include "app/cli/verb.h"
#include "ui/vtk/files/read_picture.h"

namespace relievo {

int handBackPixels(const std::filesystem::path& picture) {
  const std::optional<StoredPixels> pixels = readPixels(picture);
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
