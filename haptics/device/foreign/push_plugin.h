// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/base/task.h"
#include "haptics/device/foreign/ask_host.h"

namespace relievo::foreign {

/// The one test that pushes: a device is opened as a session opens it, and a force on its x axis
/// rises and falls again. It ends at the first fault, at zero. [worker]
/// @throw FileError, DeviceError  no host  @throw Cancelled
/// @param image  the bytes that the other tests judged
CheckResult pushPlugin(const Check& check, PluginImage image, const Conformance& how,
                       const Task& task);

}  // namespace relievo::foreign
