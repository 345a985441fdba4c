// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/sound/wav_file.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

namespace relievo::sound {
namespace {

constexpr std::uint64_t kChannels = 2, kBytesPerSample = 2;
constexpr std::uint64_t kBytesPerFrame = kChannels * kBytesPerSample;
constexpr std::size_t kChunkHead = 8;

void add(std::string& bytes, std::uint64_t value, int count) {
  for (int i = 0; i < count; ++i) bytes += static_cast<char>(value >> (8 * i) & 0xFFU);
}

/// A chunk with its name, its size, and a byte behind an odd one.
std::string chunk(std::string_view name, std::string_view content) {
  std::string bytes(name);
  add(bytes, content.size(), 4);
  bytes += content;
  if (content.size() % 2 != 0) bytes += '\0';
  return bytes;
}

/// All between "RIFF", the size, and the samples' own head.
std::string front(const std::string& comment) {
  std::string format;
  add(format, 1, 2);  // PCM.
  add(format, kChannels, 2);
  add(format, kSampleRateHz, 4);
  add(format, std::uint64_t{kSampleRateHz} * kBytesPerFrame, 4);
  add(format, kBytesPerFrame, 2);
  add(format, 8 * kBytesPerSample, 2);
  return "WAVE" + chunk("fmt ", format) +
         chunk("LIST", "INFO" + chunk("ICMT", comment + std::string(1, '\0')));
}

std::uint16_t pcm(float value) {
  constexpr float kFull = 32767;
  const float sample = std::clamp(value, -1.0F, 1.0F) * kFull;
  return static_cast<std::uint16_t>(static_cast<std::int16_t>(std::lround(sample)));
}

}  // namespace

void addPcm(std::span<const Frame> frames, std::string& bytes) {
  for (const Frame& frame : frames) {
    add(bytes, pcm(frame.left), 2);
    add(bytes, pcm(frame.right), 2);
  }
}

std::uint64_t mostWavFrames(const std::string& comment) noexcept {
  const std::uint64_t room =
      std::numeric_limits<std::uint32_t>::max() - (comment.size() + 100);  // More than front() has.
  return room / kBytesPerFrame;
}

WavFile::WavFile(const OutputFile& file, std::uint64_t frames, const std::string& comment)
    : file_(file) {
  const std::string head = front(comment);
  const std::uint64_t bytes = frames * kBytesPerFrame;
  std::string start = "RIFF";
  add(start, head.size() + kChunkHead + bytes, 4);
  start += head + "data";
  add(start, bytes, 4);
  file_.write(start);
}

void WavFile::write(std::span<const Frame> frames) {
  bytes_.clear();
  addPcm(frames, bytes_);
  file_.write(bytes_);
}

void WavFile::commit() {
  file_.commit();
}

}  // namespace relievo::sound
