// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/device_catalog.h"

#include "core/base/error.h"
#include "haptics/device/mouse_device.h"

namespace relievo {

std::vector<DeviceDriver> deviceCatalog() {
  return {{"mouse", [] { return std::vector<std::string>{"mouse"}; },
           [](const std::string& id) -> std::unique_ptr<Device> {
             if (id != "mouse") throw DeviceError("There is no mouse device named \"" + id + "\".");
             return std::make_unique<MouseDevice>();
           }}};
}

}  // namespace relievo
