// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/options/falcon_setting.h"

#include "haptics/device/falcon/settings_file.h"

namespace relievo::batch {

std::filesystem::path falconFirmware() {
  return falcon::readSettings(falcon::settingsFile()).firmware;
}

void setFalconFirmware(const std::filesystem::path& file) {
  falcon::FalconSettings settings = falcon::readSettings(falcon::settingsFile());
  settings.firmware = file.string();
  falcon::writeSettings(settings, falcon::settingsFile());
}

}  // namespace relievo::batch
