// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <string_view>

#include "core/base/task.h"

namespace relievo {

struct TouchRecording;
struct VideoRequest;

/// What is heard in a video: samples, left and right in turn, of 16 bits each, the low byte first.
/// The first one sounds with the first picture.
struct SoundTrack {
  int rate_hz = 48000;       ///< Pairs of samples a second.
  std::uint64_t frames = 0;  ///< Pairs of samples in all.
  /// Gives away all bytes, part by part. [worker] @throw Cancelled, and what `take` throws
  std::function<void(const std::function<void(std::string_view bytes)>& take, const Task& task)>
      render;
};

/// Makes the sound of a recording's part at a speed, as a request for a video says them. The
/// recording outlives the track. [worker] @throw FileError  it does not tell what was heard
using SoundTrackOf =
    std::function<SoundTrack(const TouchRecording& recording, const VideoRequest& request)>;

}  // namespace relievo
