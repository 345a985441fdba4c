// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "haptics/sound/recorded_sound.h"

namespace relievo::sound::test {

/// A recording of so many seconds at 1 kHz, whose rows a function fills. Hand and object have the
/// same scale; the window is 80 mm wide, its heights 0 to 20 mm.
inline TouchRecording recordingOf(double seconds, const std::function<void(TouchRow&)>& fill,
                                  double start_s = 3) {
  TouchRecording recording;
  recording.name = "log.csv";
  recording.windows.push_back({.id = 1, .region = {0, 0, 80, Level{0}}});
  const int rows = static_cast<int>(std::lround(1000 * seconds)) + 1;
  for (int i = 0; i < rows; ++i) {
    TouchRow& row = recording.rows.emplace_back();
    row.t_s = start_s + 0.001 * i;
    row.tick = static_cast<std::uint64_t>(i);
    row.window_id = 1;
    row.normal = {0, 0, 1};
    row.origin = CellStatus::measured;
    row.proxy = {40, 40, 0};
    TouchRow filled = row;
    filled.t_s = 0.001 * i;  // Of its own time the function sees the start at 0.
    fill(filled);
    filled.t_s = row.t_s;
    row = filled;
    row.hip = {row.hand_hip.x, row.hand_hip.y, row.hand_hip.z};
    if (row.hand_hip == DeviceMm{}) row.hand_hip = {1, 1, 1};
    row.hand_proxy = {row.proxy.x, row.proxy.y, row.proxy.z};
  }
  return recording;
}

inline std::vector<Frame> framesOf(const RecordedSound& sound,
                                   RecordedSound::Summary* summary = nullptr) {
  std::vector<Frame> all;
  const RecordedSound::Summary found = sound.render(
      [&](std::span<const Frame> part) { all.insert(all.end(), part.begin(), part.end()); });
  if (summary != nullptr) *summary = found;
  return all;
}

inline std::vector<double> leftOf(const std::vector<Frame>& frames) {
  std::vector<double> left;
  for (const Frame& frame : frames) left.push_back(frame.left);
  return left;
}

/// By the zero crossings upward between two times, each between its two frames.
inline double pitchHz(const std::vector<double>& samples, double from_s, double to_s) {
  const auto begin = static_cast<std::size_t>(from_s * kSampleRateHz);
  const auto end = static_cast<std::size_t>(to_s * kSampleRateHz);
  double first = -1, last = -1;
  int turns = -1;
  for (std::size_t i = begin + 1; i < end; ++i) {
    if (samples[i - 1] >= 0 || samples[i] < 0) continue;
    last = static_cast<double>(i) - samples[i] / (samples[i] - samples[i - 1]);
    if (turns < 0) first = last;
    ++turns;
  }
  return turns < 1 ? 0 : turns * kSampleRateHz / (last - first);
}

inline double cents(double hz, double of_hz) {
  return 1200 * std::log2(hz / of_hz);
}

inline double rms(const std::vector<double>& samples, double from_s, double to_s) {
  const auto begin = static_cast<std::size_t>(from_s * kSampleRateHz);
  const auto end = static_cast<std::size_t>(to_s * kSampleRateHz);
  double sum = 0;
  for (std::size_t i = begin; i < end; ++i) sum += samples[i] * samples[i];
  return std::sqrt(sum / static_cast<double>(end - begin));
}

/// Power between two frequencies, by a Fourier sum with a Hann window over 4096 frames.
inline double powerBetween(const std::vector<double>& samples, double from_s, double low_hz,
                           double high_hz) {
  constexpr int kFrames = 4096;
  const auto begin = static_cast<std::size_t>(from_s * kSampleRateHz);
  double power = 0;
  for (int k = static_cast<int>(low_hz * kFrames / kSampleRateHz);
       k <= static_cast<int>(high_hz * kFrames / kSampleRateHz); ++k) {
    double re = 0, im = 0;
    for (int i = 0; i < kFrames; ++i) {
      const double turn = 2 * std::numbers::pi * i / kFrames;
      const double sample =
          0.5 * (1 - std::cos(turn)) * samples[begin + static_cast<std::size_t>(i)];
      re += sample * std::cos(k * turn);
      im += sample * std::sin(k * turn);
    }
    power += re * re + im * im;
  }
  return power;
}

}  // namespace relievo::sound::test
