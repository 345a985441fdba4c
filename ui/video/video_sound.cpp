// SPDX-License-Identifier: BSD-3-Clause
#include "ui/video/video_sound.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

namespace relievo {
namespace {

constexpr std::uint64_t kBytesPerFrame = 4;  // Two channels of 16 bits.

}  // namespace

VideoSound soundOf(const VideoRequest& request, const TouchRecording* recording,
                   const SoundTrackOf& make) {
  if (!request.sound || recording == nullptr || !make) return {};
  if (request.profile == VideoProfile::images) return {};
  try {
    return {.track = make(*recording, request), .missing = {}};
  } catch (const FileError& error) {
    return {.track = {}, .missing = std::make_shared<FileError>(error)};
  }
}

SoundSpool::SoundSpool(const SoundTrack& track, double seconds, const std::filesystem::path& beside,
                       const Task& task)
    : file_(beside), rate_hz_(track.rate_hz) {
  std::uint64_t left =
      kBytesPerFrame * static_cast<std::uint64_t>(std::llround(seconds * track.rate_hz));
  const auto take = [&](std::string_view bytes) {
    const std::string_view part = bytes.substr(0, std::min<std::uint64_t>(left, bytes.size()));
    file_.write(part);
    left -= part.size();
  };
  track.render(take, task);
  const std::string silence(std::min<std::uint64_t>(left, 1U << 16U), '\0');
  while (left > 0) {
    task.check();
    take(silence);
  }
}

}  // namespace relievo
