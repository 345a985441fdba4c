// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

#include "haptics/device/falcon/falcon_device.h"

namespace relievo::falcon {

/// $XDG_CONFIG_HOME/relievo/falcon.conf: what the set-up found out, for window and command line.
std::filesystem::path settingsFile();

/// One "name value" per line. What is missing, unknown or impossible keeps its default.
/// @param serial  of one of several: what a calibration found of it stands as "name@SERIAL value"
///                and goes before "name value"; empty: any
FalconSettings readSettings(const std::filesystem::path& file, const std::string& serial = {});

/// For the driver: the file that the settings name, or the one that is found without them. Both are
/// looked at anew each time it is asked.
FirmwareSource storedFirmwareSource();

/// Whole or not at all; what the file says of other Falcons stays. @throw WriteError
/// @param serial  as above: gain and weight become this one's own, the rest is everyone's
void writeSettings(const FalconSettings& settings, const std::filesystem::path& file,
                   const std::string& serial = {});

}  // namespace relievo::falcon
