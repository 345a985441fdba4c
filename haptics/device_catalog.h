// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "haptics/device/device.h"

namespace relievo {

/// One kind of device.
struct DeviceDriver {
  std::string kind;
  std::function<std::vector<std::string>()> scan;  ///< Ids that could be opened now.
  /// A closed device. @throw DeviceError  no such id
  std::function<std::unique_ptr<Device>(const std::string& id)> make;
  /// Who felt one, and when ("by NAME, DATE"), or "never"; empty: it is no hardware that pushes.
  /// docs/user/devices.md says the same.
  std::string tried_on_hardware = {};
};

/// A plug-in for devices that comes with this program (foreign/plugin_files.h).
struct OwnPlugin {
  std::string_view file;               ///< The FILE of "plugin:FILE/ID".
  std::string_view tried_on_hardware;  ///< As a driver's.
};
inline constexpr std::array<OwnPlugin, 1> kOwnPlugins{{{"force_dimension", "never"}}};

/// All kinds this build knows, written out in the .cpp: no static registration.
std::vector<DeviceDriver> deviceCatalog();

/// Whether somebody has felt the device of that id: what its driver or its plug-in says. Empty: it
/// is no hardware that pushes. Nothing: who made its plug-in may know.
std::optional<std::string> triedOnHardware(std::string_view id);

/// The closed device of that id, "mouse" or "virtual:light"; a kind alone is its usual device. Also
/// one of a plug-in, "plugin:FILE/ID", which is no kind of this build (foreign/plugin_files.h).
/// @throw DeviceError  no such device
std::unique_ptr<Device> makeDevice(const std::string& id);

}  // namespace relievo
