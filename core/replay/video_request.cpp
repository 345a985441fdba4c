// SPDX-License-Identifier: BSD-3-Clause
#include "core/replay/video_request.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string>

#include "core/base/error.h"

namespace relievo {
namespace {

constexpr double kMostFrames = 1e6;  // Nine hours at 30 a second.

/// As people write it: 4, 0.25.
std::string plain(double value) {
  std::array<char, 32> text{};
  constexpr int kDigits = 6;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value,
                                 std::chars_format::general, kDigits);
  return {text.data(), end.ptr};
}

void within(const char* what, double value, double low, double high) {
  if (value >= low && value <= high) return;
  throw ArgumentError("A video's " + std::string(what) + " must be " + plain(low) + " to " +
                      plain(high) + ". Nothing was made.");
}

double lengthS(const VideoRequest& v, const TouchRecording* recording) {
  return recording != nullptr ? recording->endS() - recording->startS() : v.path->endS();
}

/// "the recording is 4 s long"
std::string lengthWords(const VideoRequest& v, const TouchRecording* recording) {
  return std::string("the ") + (recording != nullptr ? "recording" : "camera path") + " is " +
         plain(lengthS(v, recording)) + " s long";
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
  within("speed", v.speed, 0.01, 100);
  within("angle between the eyes in degrees", v.eye_angle_deg, 0.01, 20);
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
  const double end = lengthS(v, recording);
  const double from = std::max(0.0, v.from_s.value_or(0));
  const double to = std::min(end, v.to_s.value_or(end));
  if (!(to >= from)) {
    throw ArgumentError("There is nothing between " + plain(v.from_s.value_or(0)) + " s and " +
                        plain(v.to_s.value_or(end)) + " s: " + lengthWords(v, recording) +
                        ". Nothing was made.");
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

std::string whatIsCut(const VideoRequest& v, const TouchRecording* recording) {
  const double end = lengthS(v, recording);
  // A thousandth of a second: no one means the last sample's exact time.
  constexpr double kGraceS = 1e-3;
  const bool starts_early = v.from_s.value_or(0)<0, ends_late = v.to_s.value_or(0)> end + kGraceS;
  if (!starts_early && !ends_late) return {};
  return "The part from " + plain(v.from_s.value_or(0)) + " s to " + plain(v.to_s.value_or(end)) +
         " s is cut to " + plain(std::max(0.0, v.from_s.value_or(0))) + " s to " +
         plain(std::min(end, v.to_s.value_or(end))) + " s: " + lengthWords(v, recording) + ".";
}

}  // namespace relievo
