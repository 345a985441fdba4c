// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "core/base/task.h"
#include "core/provenance/provenance.h"
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

/// Draws and packs a whole video, frame by frame; frame i shows its own time, however long drawing
/// takes. Writes FILE.json beside it with `state`. Needs a FigureSession. [worker that may use
/// OpenGL] @param recording  null: the request's camera path alone
/// @throw ArgumentError, GraphicsError, WriteError (E401: what is whole is kept), Cancelled
VideoFacts writeVideo(const Surface& surface, const TouchRecording* recording,
                      const VideoRequest& request, const std::string& state,
                      const std::filesystem::path& file, const Task& task = {});

}  // namespace relievo
