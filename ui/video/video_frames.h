// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>

#include "core/replay/video_request.h"
#include "core/session/surface.h"
#include "ui/vtk/offscreen.h"

namespace relievo {

/// Draws the frames of a video: the detail, beside it the whole object and the plots. A frame
/// depends on its number alone, not on those before it: the same number gives the same pixels.
/// A request for one eye gives that eye's picture alone.
/// Needs a FigureSession. [one thread that may use OpenGL]
class VideoFrames {
 public:
  /// All but the task must outlive this. @param recording  null: the camera path alone
  /// @param task  also stops the drawing of a frame
  /// @throw ArgumentError, GraphicsError, Cancelled
  VideoFrames(const Surface& surface, const TouchRecording* recording, const VideoRequest& request,
              const Task& task = {});
  ~VideoFrames();
  VideoFrames(const VideoFrames&) = delete;
  VideoFrames& operator=(const VideoFrames&) = delete;

  const VideoTimes& times() const;
  /// Valid until the next call.
  /// @throw GraphicsError, ArgumentError, FileError (tiles), Cancelled
  const RgbaImage& draw(std::uint64_t frame);
  /// From the next draw() on each eye's picture is kept, too.
  void keepEyes();
  /// One eye's picture of the frame that was drawn last, the whole page. Valid until the next call.
  /// @pre keepEyes()  @param eye  left or right
  const RgbaImage& ofEye(FigureEye eye);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace relievo
