// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

namespace relievo::batch {

/// The Falcon's firmware file, or its folder, that the user has named: the first place that is
/// searched, by the window as by the command line. Empty: none.
std::filesystem::path falconFirmware();

/// From the next start of a Falcon on. @throw WriteError
void setFalconFirmware(const std::filesystem::path& file);

}  // namespace relievo::batch
