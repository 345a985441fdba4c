// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "core/base/task.h"
#include "haptics/device/foreign/ask_host.h"

namespace relievo::foreign {

/// The one test that pushes: a device is opened as a session opens it, and a force on its x axis
/// rises and falls again. It ends at the first fault, at zero. [worker]
/// @throw FileError, DeviceError  no host  @throw Cancelled
CheckResult pushPlugin(const Check& check, const std::filesystem::path& file,
                       const Conformance& how, const Task& task);

}  // namespace relievo::foreign
