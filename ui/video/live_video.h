// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "ui/video/video_file.h"

namespace relievo {

/// A video of something that goes on by itself. Whoever shows it offers pictures and never waits; a
/// thread packs them. A picture that comes while packing is behind is dropped and counted, and the
/// one before stands in its place, so that time stays true. [one thread]
class LiveVideo {
 public:
  /// Pictures that may wait: half a second at 15 a second. [format.width_px x format.height_px]
  static constexpr std::size_t kMostWaiting = 8;

  /// @throw as openVideo
  LiveVideo(const std::filesystem::path& file, const VideoFormat& format);
  ~LiveVideo();  ///< Without finish() nothing is left.
  LiveVideo(const LiveVideo&) = delete;
  LiveVideo& operator=(const LiveVideo&) = delete;

  /// @param t_s  since the start; a second picture for the same frame is passed over
  void offer(RgbaImage picture, double t_s);
  /// The same of a picture that is put together where it is packed.
  /// @param make  runs in the thread of the packing; throws nothing
  void offer(std::function<RgbaImage()> make, double t_s);
  void finish();  ///< No more will come; the file is complete once report().ended.

  struct Report {
    std::uint64_t frames = 0;   ///< Packed.
    std::uint64_t dropped = 0;  ///< Not taken because packing was behind.
    bool ended = false;
    std::string error;                       ///< Empty: all is saved.
    std::string code;                        ///< Of the error: "E401"; or empty.
    std::shared_ptr<const Message> message;  ///< The error, for the window's language; or none.
  };
  Report report() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace relievo
