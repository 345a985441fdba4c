// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/base/task.h"
#include "core/provenance/provenance.h"
#include "core/replay/sound_track.h"
#include "core/replay/video_request.h"
#include "core/session/surface.h"

namespace relievo {

/// How a video came out.
struct VideoFacts {
  std::uint64_t frames = 0;
  double seconds = 0;       ///< It lasts.
  std::uint64_t bytes = 0;  ///< Of the file, or of all pictures.
  double drawing_s = 0;     ///< What drawing took; ...
  double packing_s = 0;     ///< ... and what was waited for the encoder.
};

/// What a video carries, in its comment and beside it: where its map came from, the request, and
/// which recording it shows. One line of JSON.
std::string videoState(const Provenance& provenance, const VideoRequest& request,
                       const InputFile& recording);

/// The files that one video is written as.
struct VideoFiles {
  std::filesystem::path video;
  /// Each eye's video, too, beside it: NAME.left.mp4 and NAME.right.mp4, of the same frames.
  bool both_eyes = false;
  /// Heard in each of them, as long as the pictures last; null: they are silent. Images always are.
  const SoundTrack* sound = nullptr;
};
/// Their names, the video's own last.
std::vector<std::filesystem::path> namesOf(const VideoFiles& files);

/// Draws and packs a whole video, frame by frame; frame i shows its own time, however long drawing
/// takes. Writes FILE.json beside it with `state`. Needs a FigureSession. [worker that may use
/// OpenGL] @param recording  null: the request's camera path alone
/// @throw ArgumentError, GraphicsError, WriteError (E401: what is whole is kept), Cancelled
VideoFacts writeVideo(const Surface& surface, const TouchRecording* recording,
                      const VideoRequest& request, const std::string& state,
                      const std::filesystem::path& file, const Task& task = {});

/// The same for several files; all of them are there, or none is. What is told of bytes and time is
/// of all of them. @param state  of the request, or of that request for one eye; its `sound` says
///                               whether there is one
VideoFacts writeVideo(const Surface& surface, const TouchRecording* recording,
                      const VideoRequest& request,
                      const std::function<std::string(const VideoRequest&)>& state,
                      const VideoFiles& files, const Task& task = {});

}  // namespace relievo
