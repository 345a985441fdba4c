// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "core/base/task.h"
#include "core/file/atomic_file.h"
#include "core/replay/video_request.h"
#include "ui/vtk/offscreen.h"

namespace relievo {

/// Is there a program `ffmpeg` on the search path?
bool haveFfmpeg();

struct VideoFormat {
  VideoProfile profile = VideoProfile::talk;
  int width_px = 0, height_px = 0;
  double fps = 30;
  std::string state;  ///< What the video was made from, one JSON object; kept in the file.
  std::string title;
  /// A file of samples that are heard with the pictures, as SoundTrack says them; empty: none.
  std::filesystem::path sound = {};
  int sound_rate_hz = 0;
};

/// What the sound of a video is packed as: "aac" or, where nothing may be lost, "alac".
std::string_view soundCodec(VideoProfile profile) noexcept;

/// A video that is being written, frame by frame. Nothing stands under the final name before
/// finish(), and of a member of a set before the set is committed; without it, nothing is left.
/// [one thread]
class VideoFile {
 public:
  VideoFile() = default;
  virtual ~VideoFile() = default;
  VideoFile(const VideoFile&) = delete;
  VideoFile& operator=(const VideoFile&) = delete;

  /// Waits while the encoder is behind, and looks at the task at least every 50 ms.
  /// @throw WriteError (E401)  the disk is full: what was whole is kept under the final name, and
  ///                           the sentence says how much; or the encoder refuses
  /// @throw Cancelled
  virtual void add(const RgbaImage& frame, const Task& task) = 0;
  /// @throw WriteError, Cancelled
  virtual void finish(const Task& task) = 0;
  virtual std::uint64_t frames() const noexcept = 0;  ///< Added; after an error: saved.
  /// After an error: what was whole is kept, or waits as a member of its set.
  virtual bool isPartKept() const noexcept = 0;
};

/// By ffmpeg as MP4, or for `images` as frame_000001.png ... in a folder of that name, without
/// sound.
/// @throw WriteError     cannot be written; no ffmpeg; the folder has pictures already
/// @throw ArgumentError  a file name that does not end in .mp4
std::unique_ptr<VideoFile> openVideo(const OutputFile& file, const VideoFormat& format);

}  // namespace relievo
