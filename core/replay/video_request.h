// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/relief/look.h"
#include "core/relief/stereo.h"
#include "core/replay/camera_path.h"
#include "core/replay/touch_recording.h"

namespace relievo {

/// What a video is for, and so how its pictures are packed.
enum class VideoProfile {
  talk,      ///< H.264, colours halved in size (4:2:0): plays everywhere.
  archive,   ///< H.264 without loss, in RGB: every pixel comes back.
  anaglyph,  ///< H.264 with every pixel's colour (4:4:4): red and cyan stay apart.
  images,    ///< A folder of PNG files; needs no other program.
};
inline constexpr std::array<std::string_view, 4> kVideoProfileNames{"talk", "archive", "anaglyph",
                                                                    "images"};
inline constexpr std::string_view name(VideoProfile profile) noexcept {
  return kVideoProfileNames[static_cast<std::size_t>(profile)];
}
std::optional<VideoProfile> videoProfile(std::string_view name);

/// Everything about a video that surface and recording do not decide; one record for the window
/// and `relievo video`.
struct VideoRequest {
  VideoProfile profile = VideoProfile::talk;
  int width_px = 1280, height_px = 720;  ///< 64 .. 4096, even.
  double fps = 30;                       ///< Pictures a second, 1 .. 120.
  double speed = 1;                      ///< Seconds of the recording per second of video.
  std::optional<double> from_s, to_s;    ///< Of recording or path, since its start.
  bool plots = true;                     ///< z of hand and proxy, force, with a cursor.
  bool overview = true;                  ///< The whole object with the pink window.
  bool scale_bar = true;
  /// What the recording sounds like, at this speed; a camera path and images have no sound.
  bool sound = true;
  ReliefLook look;
  StereoPrint stereo = StereoPrint::off;  ///< Pairs are of the whole frame.
  double eye_angle_deg = 4;
  bool swap_eyes = false;
  FigureEye eye = FigureEye::both;  ///< One of the two pictures that stereo would mix.
  std::optional<CameraPath> path;   ///< Nothing: the camera looks at the recorded window.
};

/// @throw ArgumentError  a number beyond its limits, or choices that exclude each other
void check(const VideoRequest& request);

/// Which time each frame shows: frame i shows from_s + i speed / fps, and nothing else.
struct VideoTimes {
  double from_s = 0, step_s = 0;
  std::uint64_t frames = 0;
  double ofFrame(std::uint64_t frame) const noexcept {
    return from_s + static_cast<double>(frame) * step_s;
  }
};
/// Of the recording if there is one, else of the path. Times are since its start.
/// @throw ArgumentError  neither of both, or an empty part of it
VideoTimes timesOf(const VideoRequest& request, const TouchRecording* recording);
/// A sentence, if the request asks for more than there is; else empty. For a request that timesOf()
/// takes.
std::string whatIsCut(const VideoRequest& request, const TouchRecording* recording);

}  // namespace relievo
