// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace relievo {

/// Follows a fragmented MP4 (ISO/IEC 14496-12) while it is written, and knows where it could be cut
/// and still be a whole file: after its head, and after each fragment. Its frames are the samples
/// of its first track.
class Mp4Boxes {
 public:
  void add(std::span<const std::uint8_t> bytes);
  std::uint64_t wholeBytes() const { return whole_bytes_; }  ///< 0: not even a head.
  std::uint64_t wholeFrames() const { return whole_frames_; }

 private:
  void begin();
  void end();

  std::vector<std::uint8_t> head_;      // Of the present box, 8 or 16 bytes.
  std::vector<std::uint8_t> fragment_;  // Content of the present "moof".
  std::string type_;
  std::uint64_t left_ = 0;  // Of the present box's content.
  std::uint64_t seen_ = 0, whole_bytes_ = 0, whole_frames_ = 0, frames_ = 0;
};

}  // namespace relievo
