// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "haptics/device/falcon/falcon_device.h"

namespace relievo::falcon {

/// $XDG_CONFIG_HOME/relievo/falcon.conf: what the set-up found out, for window and command line.
std::filesystem::path settingsFile();

/// One "name value" per line. What is missing, unknown or impossible keeps its default.
FalconSettings readSettings(const std::filesystem::path& file);

/// For the driver: the file that the settings name, or the one that is found without them. Both are
/// looked at anew each time it is asked.
FirmwareSource storedFirmwareSource();

/// Whole or not at all. @throw WriteError
void writeSettings(const FalconSettings& settings, const std::filesystem::path& file);

}  // namespace relievo::falcon
