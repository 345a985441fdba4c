// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <string>
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

/// All kinds this build knows, written out in the .cpp: no static registration.
std::vector<DeviceDriver> deviceCatalog();

/// The closed device of that id, "mouse" or "virtual:light"; a kind alone is its usual device. Also
/// one of a plug-in, "plugin:FILE/ID", which is no kind of this build (foreign/plugin_files.h).
/// @throw DeviceError  no such device
std::unique_ptr<Device> makeDevice(const std::string& id);

}  // namespace relievo
