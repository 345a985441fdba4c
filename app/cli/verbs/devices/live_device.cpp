// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/verbs/devices/live_device.h"

#include <array>
#include <cstdint>
#include <cstdio>

#include "app/cli/verb.h"
#include "core/base/failure.h"
#include "haptics/device/falcon/falcon_device.h"
#include "haptics/device/haply/haply_device.h"
#include "haptics/rt/realtime_thread.h"

namespace relievo::batch {
namespace {

using falcon::LinkState;

constexpr std::int64_t kLookNs = 20'000'000;

/// Marks of the homing, arm by arm: "Top arm found, right arm missing, left arm missing."
std::string armsText(std::uint8_t homed) {
  constexpr std::array<const char*, falcon::kArms> kArmNames{"Top arm", "right arm", "left arm"};
  std::string text;
  for (std::size_t i = 0; i < kArmNames.size(); ++i) {
    text += (i == 0 ? "" : ", ") + std::string(kArmNames[i]) +
            ((homed >> i & 1U) != 0 ? " found" : " missing");
  }
  return text + ".";
}

std::string tooLate(const falcon::LinkStatus& status, double seconds, const std::string& undone) {
  const bool homing = status.state == LinkState::homing || status.state == LinkState::pull_out;
  std::array<char, 32> number{};
  std::snprintf(number.data(), number.size(), "%g", seconds);
  return std::string("The Falcon was not ") + (homing ? "homed" : "ready") + " within " +
         number.data() + " s, and " + undone + ". " +
         (homing ? armsText(status.homed) + " Home it" : "Look at it in 'relievo devices'") +
         ", or allow more time with --ready.";
}

}  // namespace

void waitUntilReady(falcon::FalconDevice& device, double seconds, const std::string& undone,
                    const Task& task) {
  std::string told;
  int homed_told = -1;
  const std::int64_t give_up = monotonicNs() + static_cast<std::int64_t>(1e9 * seconds);
  while (true) {
    const falcon::LinkStatus& status = device.status();
    const Message message = falcon::describe(status);
    const std::string code = codeOf(message);
    if (status.state == LinkState::ready) return;
    const bool hopeless = status.state == LinkState::no_firmware ||
                          status.state == LinkState::not_started ||
                          status.state == LinkState::absent || status.state == LinkState::several;
    if (hopeless) throw DeviceError(message);
    if (monotonicNs() > give_up) throw DeviceError(tooLate(status, seconds, undone), code);
    if (status.state != LinkState::closed && englishText(message) != told) {
      told = englishText(message);
      tell(code.empty() ? told : code + ": " + told);
    }
    const bool homing = status.state == LinkState::homing || status.state == LinkState::pull_out;
    if (homing && status.homed != homed_told) {
      homed_told = status.homed;
      tell(armsText(status.homed));
    }
    task.check();
    sleepUntil(monotonicNs() + kLookNs);
  }
}

void waitUntilReady(haply::HaplyDevice& device, double seconds, const Task& task) {
  std::string told;
  const std::int64_t give_up = monotonicNs() + static_cast<std::int64_t>(1e9 * seconds);
  while (true) {
    const haply::LinkStatus& status = device.status();
    if (status.state == haply::LinkState::ready) return;
    const Message message = haply::describe(status);
    if (monotonicNs() > give_up) {
      throw failure<MessageId::haply_too_late>(
          NumberArgument{seconds, 3, NumberArgument::Form::significant, MessageUnit::second},
          message);
    }
    const bool news = status.state != haply::LinkState::checking && englishText(message) != told;
    if (news) {
      told = englishText(message);
      const std::string code = codeOf(message);
      tell(code.empty() ? told : code + ": " + told);
    }
    task.check();
    sleepUntil(monotonicNs() + kLookNs);
  }
}

}  // namespace relievo::batch
