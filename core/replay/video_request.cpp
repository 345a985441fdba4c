// SPDX-License-Identifier: BSD-3-Clause
#include "core/replay/video_request.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/base/error.h"

namespace relievo {
namespace {

constexpr double kMostFrames = 1e6;  // Nine hours at 30 a second.

void within(const char* what, double value, double low, double high) {
  if (value >= low && value <= high) return;
  throw ArgumentError("A video's " + std::string(what) + " must be " +
                      std::to_string(static_cast<int>(low)) + " to " +
                      std::to_string(static_cast<int>(high)) + ". Nothing was made.");
}

}  // namespace

std::optional<VideoProfile> videoProfile(std::string_view name) {
  const auto* const found = std::find(kVideoProfileNames.begin(), kVideoProfileNames.end(), name);
  if (found == kVideoProfileNames.end()) return std::nullopt;
  return static_cast<VideoProfile>(found - kVideoProfileNames.begin());
}

void check(const VideoRequest& v) {
  within("width in pixels", v.width_px, 64, 4096);
  within("height in pixels", v.height_px, 64, 4096);
  within("frames per second", v.fps, 1, 120);
  within("speed in hundredths", 100 * v.speed, 1, 10'000);
  within("angle between the eyes in hundredths of a degree", 100 * v.eye_angle_deg, 1, 2000);
  if (v.width_px % 2 != 0 || v.height_px % 2 != 0) {
    throw ArgumentError("A video's width and height must be even. Nothing was made.");
  }
  if (v.stereo != StereoPrint::off && !isAnaglyph(v.stereo)) {
    throw ArgumentError("A video's stereo must be grey, half or dubois. Nothing was made.");
  }
  if (isAnaglyph(v.stereo) && v.profile == VideoProfile::talk) {
    throw ArgumentError(
        "The profile talk halves the colours' size, which mixes the two eyes of an anaglyph. "
        "Choose the profile anaglyph or archive. Nothing was made.");
  }
  if (v.path) check(*v.path);
}

VideoTimes timesOf(const VideoRequest& v, const TouchRecording* recording) {
  if (recording == nullptr && !v.path) {
    throw ArgumentError("A video needs a recording or a camera path. Nothing was made.");
  }
  const double end =
      recording != nullptr ? recording->endS() - recording->startS() : v.path->endS();
  const double from = std::max(0.0, v.from_s.value_or(0));
  const double to = std::min(end, v.to_s.value_or(end));
  if (!(to >= from)) {
    throw ArgumentError("There is nothing between " + std::to_string(from) + " s and " +
                        std::to_string(to) + " s. Nothing was made.");
  }
  const double step = v.speed / v.fps;
  // A thousandth of a frame's grace: lengths are sums of floating-point steps.
  const double frames = std::floor((to - from) / step + 1e-3) + 1;
  if (frames > kMostFrames) {
    throw ArgumentError(
        "This would be more than a million frames. Choose a part of the recording.");
  }
  return {from, step, static_cast<std::uint64_t>(frames)};
}

}  // namespace relievo
