// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <QPointer>
#include <string>

#include "haptics/device/pad/rumbler.h"
#include "plugins/haptics/panel/haptics_panel.h"
#include "plugins/haptics/touch_actions.h"
#include "plugins/haptics/touch_settings.h"

namespace relievo {

/// What the parts of the plugin share while it is attached. [GUI thread]
struct TouchParts {
  Host& host;
  TouchSettings& settings;            ///< The plugin's own, which outlive this.
  std::string& requested;             ///< Id of the device that the person asked for, likewise.
  TouchActions actions = {};          ///< All null until the host has them.
  QPointer<HapticsPanel> panel = {};  ///< Null: not there yet, or the host has deleted it.
  /// Of gamepads; every session feeds it, and the settings of buttons switch it.
  std::shared_ptr<pad::Rumbler> rumbler = std::make_shared<pad::Rumbler>();
  bool forces_asked = false;  ///< Whether the person wants forces.

  /// After a change of the settings that the panel did not make.
  void showSettings() const {
    if (panel) panel->setSettings(settings);
  }
};

}  // namespace relievo
