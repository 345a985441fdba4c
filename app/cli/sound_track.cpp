// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/sound_track.h"

#include <memory>
#include <span>
#include <string>

#include "core/replay/video_request.h"
#include "haptics/sound/recorded_sound.h"
#include "haptics/sound/wav_file.h"

namespace relievo::batch {

SoundTrack soundTrackOf(const TouchRecording& recording, const VideoRequest& request) {
  sound::SoundRequest of;
  of.from_s = request.from_s;
  of.to_s = request.to_s;
  of.speed = request.speed;
  const auto made = std::make_shared<const sound::RecordedSound>(recording, of);
  return {.rate_hz = sound::kSampleRateHz,
          .frames = made->frames(),
          .render = [made](const auto& take, const Task& task) {
            std::string bytes;
            made->render(
                [&](std::span<const sound::Frame> frames) {
                  bytes.clear();
                  sound::addPcm(frames, bytes);
                  take(bytes);
                },
                task);
          }};
}

}  // namespace relievo::batch
