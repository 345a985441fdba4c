// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QByteArray>

namespace relievo {

enum class SpaceMouseMoves { hand, view };

/// What people choose about buttons and the SpaceMouse; remembered between sessions.
struct ButtonSettings {
  bool one_button = false;  ///< Any button scans through a few commands.
  double scan_s = 1.5;      ///< How long each is offered.
  SpaceMouseMoves space_mouse = SpaceMouseMoves::hand;
  bool rumble = false;  ///< Gamepads rumble at contact and edge: a cue, no force.
  friend bool operator==(const ButtonSettings&, const ButtonSettings&) = default;
};
inline constexpr double kLeastScanS = 0.5, kMostScanS = 5;

/// Adds them to a JSON object that holds other settings.
QByteArray withButtons(const QByteArray& json, const ButtonSettings& settings);
/// Unknown or impossible entries keep their defaults.
ButtonSettings buttonSettingsFromJson(const QByteArray& json);

}  // namespace relievo
