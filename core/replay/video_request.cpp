// SPDX-License-Identifier: BSD-3-Clause
#include "core/replay/video_request.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string>

#include "core/base/failure.h"
#include "core/relief/eye_angle.h"

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

/// The same in a message.
NumberArgument plainNumber(double value) {
  return {.value = value, .digits = 6, .form = NumberArgument::Form::significant};
}

template <MessageId refusal>
void requireWithin(double value, double low, double high) {
  if (value >= low && value <= high) return;
  throw failure<refusal>(plainNumber(low), plainNumber(high));
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
  requireWithin<MessageId::video_width>(v.width_px, 64, 4096);
  requireWithin<MessageId::video_height>(v.height_px, 64, 4096);
  requireWithin<MessageId::video_rate>(v.fps, 1, 120);
  requireWithin<MessageId::video_speed>(v.speed, 0.01, 100);
  requireWithin<MessageId::video_eye_angle>(v.eye_angle_deg, kLeastEyeAngleDeg, kMostEyeAngleDeg);
  if (v.width_px % 2 != 0 || v.height_px % 2 != 0) {
    throw failure<MessageId::video_size_odd>();
  }
  const bool shares_colours = isAnaglyph(v.stereo) || v.stereo == StereoPrint::interlaced;
  if (shares_colours && v.profile == VideoProfile::talk) {
    throw failure<MessageId::video_talk_anaglyph>();
  }
  if (v.path) check(*v.path);
}

VideoTimes timesOf(const VideoRequest& v, const TouchRecording* recording) {
  if (recording == nullptr && !v.path) {
    throw failure<MessageId::video_of_nothing>();
  }
  const double end = lengthS(v, recording);
  const double from = std::max(0.0, v.from_s.value_or(0));
  const double to = std::min(end, v.to_s.value_or(end));
  if (!(to >= from)) {
    const NumberArgument first = plainNumber(v.from_s.value_or(0));
    const NumberArgument last = plainNumber(v.to_s.value_or(end));
    const NumberArgument length = plainNumber(lengthS(v, recording));
    if (recording != nullptr) {
      throw failure<MessageId::video_beyond_recording>(first, last, length);
    }
    throw failure<MessageId::video_beyond_path>(first, last, length);
  }
  const double step = v.speed / v.fps;
  // A thousandth of a frame's grace: lengths are sums of floating-point steps.
  const double frames = std::floor((to - from) / step + 1e-3) + 1;
  if (frames > kMostFrames) {
    throw failure<MessageId::video_too_long>();
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
