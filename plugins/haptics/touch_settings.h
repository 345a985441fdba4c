// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QByteArray>
#include <string>

#include "haptics/loop/haptic_core.h"
#include "haptics/loop/surface_preset.h"
#include "haptics/training/training.h"

namespace relievo {

/// The sounds of a touch while it goes on.
struct SoundSettings {
  bool on = false;
  int volume_percent = 50;
  friend bool operator==(const SoundSettings&, const SoundSettings&) = default;
};
inline constexpr int kVolumeStep = 10;  ///< Percent.

/// What people choose about touch; remembered between sessions. Whether forces are on is not.
struct TouchSettings {
  int strength_percent = 60;
  SurfaceFeel feel;
  std::string firmness;          ///< A raster that says where it is firm; empty: the origins do.
  std::string device = "mouse";  ///< An id of deviceCatalog().
  double window_silence_s = 2;   ///< ForceStopOptions; only in the settings' file.
  bool bound_by_rate = true;     ///< Likewise: false only where a device is emulated (E306).
  bool holds_grip = true;        ///< HapticOptions.
  GripPosition grip = GripPosition::upright;  ///< Likewise.
  double limit_n = ForceOptions{}.limit_n;    ///< Of any force; only in the file of an exhibit.
  int introduction_shapes = kTrainingShapes;  ///< The first so many; likewise.
  int guide_rounds = kMostRounds;             ///< Round an outline; likewise.
  SoundSettings sound;
  bool felt_patterns = false;  ///< Taps that say what sounds and speech say (FeltPattern).
  friend bool operator==(const TouchSettings&, const TouchSettings&) = default;
};

inline constexpr double kLeastStiffness = 0.05, kMostStiffness = 1.5;  ///< N per mm of hand.
inline constexpr double kMostFrictionAsked = 1;
inline constexpr double kMostDamping = 0.002;  ///< N s per mm of hand.
inline constexpr double kLeastLimitN = 0.5;
inline constexpr double kLeastSilenceS = 0.5, kMostSilenceS = 30;
inline constexpr int kStrengthStep = 10;  ///< Percent; a smaller change of force is hardly felt.

/// For the loop, which keeps them within what the device can do.
HapticOptions hapticOptions(const TouchSettings& settings, bool forces_on);

QByteArray toJson(const TouchSettings& settings);
/// Unknown or impossible entries keep their defaults.
TouchSettings touchSettingsFromJson(const QByteArray& json);

}  // namespace relievo
