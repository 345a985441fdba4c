// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/record/recording_error.h"

#include <cerrno>
#include <cstring>
#include <string>

namespace relievo {

namespace {
/// There is no room, or none for this user or this file.
bool isFull(int error) {
  return error == ENOSPC || error == EFBIG || error == EDQUOT;
}
}  // namespace

WriteError recordingRefused(const std::filesystem::path& file, int why) {
  const std::string begun = "The recording \"" + file.string() + "\" cannot be written: ";
  if (isFull(why)) {
    return WriteError(
        begun + "disk full. Nothing was kept. Free some space or choose another place.", "E401");
  }
  return WriteError(
      begun + (why == 0 ? "HDF5 refuses it" : std::strerror(why)) + ". Choose another place.",
      "E401");
}

WriteError recordingStopped(const std::filesystem::path& file, int why, std::uint64_t rows) {
  const std::string reason = why == 0      ? "HDF5 could not write"
                             : isFull(why) ? "disk full"
                                           : std::strerror(why);
  return WriteError("Recording stopped: " + reason + ". " + std::to_string(rows) +
                        " samples are saved and complete in \"" + file.string() + "\".",
                    "E401");
}

}  // namespace relievo
