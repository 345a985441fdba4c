// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "core/base/error.h"
#include "core/base/task.h"
#include "core/file/atomic_file.h"
#include "core/replay/sound_track.h"
#include "core/replay/video_request.h"

namespace relievo {

/// The sound of a video, or why it has none although it was asked for.
struct VideoSound {
  std::optional<SoundTrack> track;
  std::shared_ptr<const FileError> missing;
};
/// Of a recording, where the request asks for sound and the profile can hold it; else neither.
/// [worker] @param make  empty: nothing can be heard here  @throw Cancelled
VideoSound soundOf(const VideoRequest& request, const TouchRecording* recording,
                   const SoundTrackOf& make);

/// The samples of a video's sound on the disk, exactly as long as its pictures last; they go with
/// this. [worker]
class SoundSpool {
 public:
  /// What is longer is cut, what is shorter ends in silence. @param beside  the video
  /// @throw CannotWrite, Cancelled
  SoundSpool(const SoundTrack& track, double seconds, const std::filesystem::path& beside,
             const Task& task);

  const std::filesystem::path& path() const noexcept { return file_.path(); }
  int rateHz() const noexcept { return rate_hz_; }

 private:
  AtomicFile file_;
  int rate_hz_;
};

}  // namespace relievo
