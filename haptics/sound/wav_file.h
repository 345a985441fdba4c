// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "core/file/atomic_file.h"
#include "haptics/sound/synth.h"

namespace relievo::sound {

/// Adds frames as they stand in files: left and right in turn, 16 bits each, the low byte first.
void addPcm(std::span<const Frame> frames, std::string& bytes);

/// Frames that one WAV file holds, whose sizes have 32 bits: more than six hours.
std::uint64_t mostWavFrames(const std::string& comment) noexcept;

/// Writes a WAV file: two channels, 48 kHz, 16 bits, and a text about where it came from (the chunk
/// ICMT of LIST INFO). It is there whole or not at all. [worker]
class WavFile {
 public:
  /// @param frames  that will be written; at most mostWavFrames()
  /// @throw WriteError
  WavFile(const OutputFile& file, std::uint64_t frames, const std::string& comment);
  /// @throw WriteError
  void write(std::span<const Frame> frames);
  /// All frames are written. @throw WriteError
  void commit();

 private:
  AtomicFile file_;
  std::string bytes_;  // Of one write.
};

}  // namespace relievo::sound
