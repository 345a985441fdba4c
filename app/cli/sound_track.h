// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/replay/sound_track.h"

namespace relievo::batch {

/// The sound that `relievo sound` makes of the recording's part at the request's speed, sample for
/// sample; for programs that draw videos. The recording outlives it. [worker]
/// @throw FileError  no row, or it does not tell where the hand was
/// @throw ArgumentError  nothing lies between the times
SoundTrack soundTrackOf(const TouchRecording& recording, const VideoRequest& request);

}  // namespace relievo::batch
