// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/record/recording_error.h"

#include <cerrno>
#include <cstring>

#include "core/base/failure.h"

namespace relievo {

namespace {
/// There is no room, or none for this user or this file.
bool isFull(int error) {
  return error == ENOSPC || error == EFBIG || error == EDQUOT;
}
}  // namespace

WriteError recordingRefused(const std::filesystem::path& file, int why) {
  if (isFull(why)) return failure<MessageId::recording_refused_disk_full>(file);
  if (why == 0) return failure<MessageId::recording_refused_by_hdf5>(file);
  return failure<MessageId::recording_refused>(file, std::strerror(why));
}

WriteError recordingStopped(const std::filesystem::path& file, int why, std::uint64_t rows) {
  if (why == 0) return failure<MessageId::recording_stopped_by_hdf5>(rows, file);
  if (isFull(why)) return failure<MessageId::recording_stopped_disk_full>(rows, file);
  return failure<MessageId::recording_stopped>(std::strerror(why), rows, file);
}

}  // namespace relievo
