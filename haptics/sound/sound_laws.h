// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

// How a touch sounds, as formulas (docs/adr/0166). Speeds and forces are the hand's, so that the
// same movement sounds the same at every scale. All are pure. [any thread]
namespace relievo::sound {

inline constexpr int kSampleRateHz = 48000;

// Largest samples of each, before the ceiling: together they stay below 1.
inline constexpr double kLeastClick = 0.07, kMostClick = 0.40;
inline constexpr double kMostFriction = 0.12;
inline constexpr double kToneLevel = 0.10;
inline constexpr double kNoteLevel = 0.25;  // -12 dBFS.

/// Peak of the click with which a hand that came with this speed along the normal touches.
inline double clickPeak(double approach_mm_per_s) noexcept {
  constexpr double kFastMmPerS = 400;
  const double share = std::clamp(approach_mm_per_s / kFastMmPerS, 0.0, 1.0);
  return kLeastClick + (kMostClick - kLeastClick) * std::pow(share, 0.7);
}

/// The click's three damped sines.
struct Partial {
  double hz, decay_s, share;
};
inline constexpr std::array<Partial, 3> kClick{
    {{1800, 0.004, 0.5}, {3100, 0.0025, 0.3}, {5200, 0.0015, 0.2}}};

/// Middle of the band in which a sliding hand rustles.
inline double frictionHz(double slide_mm_per_s) noexcept {
  constexpr double kMostHz = 6400;
  return std::min(400 + 6 * std::max(0.0, slide_mm_per_s), kMostHz);
}
inline constexpr double kFrictionQ = 1.5;

/// How loud it rustles, as rms: with the root of the power that the hand gives to the surface.
inline double frictionRms(double force_n, double slide_mm_per_s) noexcept {
  constexpr double kFullMilliwatt = 400;  // 4 N at 100 mm/s.
  constexpr double kFullRms = 0.03;       // A quarter of its largest sample: noise has peaks.
  const double power = std::max(0.0, force_n) * std::max(0.0, slide_mm_per_s);
  return kFullRms * std::sqrt(std::min(power / kFullMilliwatt, 1.0));
}

/// Pitch of a height: the lowest of the object 200 Hz, the highest two octaves above it.
/// @param share  of the range of heights, 0 .. 1; what is beyond is held there
inline double heightHz(double share) noexcept {
  return 200 * std::exp2(2 * std::clamp(share, 0.0, 1.0));
}

/// Left and right of a place across the window: the power is the same everywhere.
/// @param place  0 left .. 1 right
struct Sides {
  double left = 0, right = 0;
};
inline Sides sidesOf(double place) noexcept {
  const double angle = std::clamp(place, 0.0, 1.0) * std::numbers::pi / 2;
  return {std::cos(angle), std::sin(angle)};
}

/// What is heard once, when it happens.
enum class Earcon : std::uint8_t {
  contact,       ///< A click.
  edge,          ///< A low thud: the surface ends here.
  not_measured,  ///< A soft double click: filled ground begins.
  finer,         ///< Two notes up.
  coarser,       ///< Two notes down.
  done,          ///< Three notes up.
  problem,       ///< Two low notes.
  corner         ///< A short high note: the guide waits at a corner.
};
inline constexpr int kEarcons = 8;

/// One tone of an earcon.
struct Note {
  double hz = 0, begins_s = 0, lasts_s = 0;
  double level = 1;    ///< Of kNoteLevel.
  double decay_s = 0;  ///< 0: it is held, with soft ends.
};
struct Notes {
  std::array<Note, 3> list{};
  int count = 0;
};
/// Each is at most 50 ms long, three notes 150 ms. Of a contact there is none: it has its click.
constexpr Notes notesOf(Earcon earcon) noexcept {
  constexpr double kS = 0.05;
  switch (earcon) {
    case Earcon::edge:
      return {{{{110, 0, kS, 1, 0.012}}}, 1};
    case Earcon::not_measured:
      return {{{{1200, 0, 0.015, 0.5, 0.003}, {1200, 0.035, 0.015, 0.5, 0.003}}}, 2};
    case Earcon::finer:
      return {{{{440, 0, kS / 2}, {660, kS / 2, kS / 2}}}, 2};
    case Earcon::coarser:
      return {{{{660, 0, kS / 2}, {440, kS / 2, kS / 2}}}, 2};
    case Earcon::done:
      return {{{{523, 0, kS}, {659, kS, kS}, {784, 2 * kS, kS}}}, 3};
    case Earcon::problem:
      return {{{{220, 0, kS}, {165, kS, kS}}}, 2};
    case Earcon::corner:
      return {{{{880, 0, kS}}}, 1};
    case Earcon::contact:
      break;
  }
  return {};
}

}  // namespace relievo::sound
