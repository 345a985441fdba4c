// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/task.h"
#include "core/message/message.h"
#include "haptics/device/foreign/checks.h"
#include "haptics/device/foreign/device_page.h"

namespace relievo::foreign {

/// Why a host could not do what it was asked: the sentence of a trouble.
Message messageOf(HostTrouble trouble, int number, const std::string& text);

struct SeenDevice {
  std::string id, name;  ///< The id as the plug-in has it.
};
/// What a plug-in says of itself, asked in a process of its own.
struct ScannedPlugin {
  std::string name, version, maker, licence;
  std::vector<SeenDevice> devices;
  std::optional<Message> trouble;  ///< Why it cannot be used; then there is nothing else.
};
/// Opens no device; takes 5 s at most. [worker] @throw FileError, DeviceError  no host  @throw
/// Cancelled
ScannedPlugin scanPlugin(const std::filesystem::path& file, const Task& task = {});

enum class Verdict : std::uint8_t { passed, failed, skipped };
struct CheckResult {
  Check check;
  Verdict verdict = Verdict::failed;
  std::string why;  ///< Of one that did not pass.
};
struct Conformance {
  std::string device;  ///< Its id in the plug-in; empty: no device is opened.
  double newton = 0;   ///< 0: no force is shown.
  double seconds = 2;  ///< How long each test watches steps.
};
/// All of kChecks, each in a process of its own. [worker] @throw as scanPlugin
std::vector<CheckResult> checkPlugin(const std::filesystem::path& file, const Conformance& how,
                                     const Task& task = {});

}  // namespace relievo::foreign
