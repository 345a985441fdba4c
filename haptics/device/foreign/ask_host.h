// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/base/task.h"
#include "haptics/device/foreign/foreign_device.h"
#include "haptics/device/foreign/host_answers.h"
#include "haptics/device/foreign/plugin_image.h"

namespace relievo::foreign {

/// Opens no device; takes 5 s at most. [worker] @throw FileError, DeviceError  no host  @throw
/// Cancelled
ScannedPlugin scanPlugin(const PluginImage& image, const Task& task = {});
/// Of a file that somebody names; one that cannot be read has that trouble.
ScannedPlugin scanPlugin(const std::filesystem::path& file, const Task& task = {});

struct Conformance {
  std::string device;  ///< Its id in the plug-in; empty: no device is opened.
  double newton = 0;   ///< 0: no force is shown.
  double seconds = 2;  ///< How long each test watches steps.
  /// Asked before the device is to push, after all other tests: does a hand hold the grip? Without
  /// it, or without a yes, no force is shown.
  std::function<bool()> is_held = {};
  Patience patience = {};  ///< Of the test that pushes.
};
/// All of kChecks, each in a process of its own. The one that pushes runs as a session does: under
/// the host's guard, its limits, its rise and its watchdogs; and not at all if another test failed.
/// [worker] @throw as scanPlugin, FileError  the file cannot be read
std::vector<CheckResult> checkPlugin(const std::filesystem::path& file, const Conformance& how,
                                     const Task& task = {});

}  // namespace relievo::foreign
