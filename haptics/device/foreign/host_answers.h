// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

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
/// Of what came through the pipe, whoever wrote it: texts have nothing that a terminal takes for a
/// command, ids are of [a-z0-9._-]. What is none of that is left out.
ScannedPlugin pluginOf(std::string_view answer);

enum class Verdict : std::uint8_t { passed, failed, skipped };
struct CheckResult {
  Check check;
  Verdict verdict = Verdict::failed;
  std::string why;  ///< Of one that did not pass.
};
/// Likewise, of one test.
CheckResult resultOf(const Check& check, std::string_view answer);

}  // namespace relievo::foreign
