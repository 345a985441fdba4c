// SPDX-License-Identifier: BSD-3-Clause
#include "app/batch/verb_devices_falcon.h"

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <memory>

#include "app/batch/json.h"
#include "core/base/error.h"
#include "haptics/device/falcon/calibration.h"
#include "haptics/device/falcon/falcon_device.h"
#include "haptics/device/falcon/self_test.h"
#include "haptics/device/falcon/settings_file.h"
#include "haptics/device/falcon/usb_bus.h"
#include "haptics/rt/realtime_thread.h"

namespace relievo::batch {
namespace {

using falcon::LinkState;

constexpr std::int64_t kMs = 1'000'000;

/// Waits a tick; forwards Ctrl+C.
void tickUntil(std::int64_t deadline_ns, const Task& task) {
  task.check();
  sleepUntil(deadline_ns);
}

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

std::string tooLate(const falcon::LinkStatus& status, double seconds) {
  const bool homing = status.state == LinkState::homing || status.state == LinkState::pull_out;
  std::array<char, 32> number{};
  std::snprintf(number.data(), number.size(), "%g", seconds);
  return std::string("The Falcon was not ") + (homing ? "homed" : "ready") + " within " +
         number.data() + " s, and nothing was tried. " +
         (homing ? armsText(status.homed) + " Home it" : "Look at it in 'relievo devices'") +
         ", or allow more time with --ready.";
}

/// Tells every new state and mark on stderr until the Falcon is ready.
/// @throw DeviceError  it is not, and why
void waitUntilReady(falcon::FalconDevice& device, double seconds, const Task& task) {
  std::string told;
  int homed_told = -1;
  const std::int64_t give_up = monotonicNs() + static_cast<std::int64_t>(1e9 * seconds);
  while (true) {
    const falcon::LinkStatus& status = device.status();
    const falcon::LinkMessage message = falcon::describe(status);
    if (status.state == LinkState::ready) return;
    const bool hopeless = status.state == LinkState::no_firmware ||
                          status.state == LinkState::not_started ||
                          status.state == LinkState::absent;
    if (hopeless) throw DeviceError(message.screen, message.code);
    if (monotonicNs() > give_up) throw DeviceError(tooLate(status, seconds), message.code);
    if (status.state != LinkState::closed && message.screen != told) {
      told = message.screen;
      tell(message.code.empty() ? told : message.code + ": " + told);
    }
    const bool homing = status.state == LinkState::homing || status.state == LinkState::pull_out;
    if (homing && status.homed != homed_told) {
      homed_told = status.homed;
      tell(armsText(status.homed));
    }
    tickUntil(monotonicNs() + 20 * kMs, task);
  }
}

std::unique_ptr<falcon::FalconDevice> openFalcon(const falcon::FalconSettings& settings) {
  auto device = std::make_unique<falcon::FalconDevice>(std::make_unique<falcon::UsbBus>(),
                                                       falcon::storedFirmwareSource(), settings);
  device->open();
  return device;
}

/// Looks without waiting whether a line has come.
class EnterKey {
 public:
  /// At a terminal only from now on: what was typed before is no answer.
  EnterKey() {
    while (isatty(STDIN_FILENO) != 0 && take() && !ended_) {
    }
    line_ = false;
  }
  /// @throw ArgumentError  none can come any more
  bool pressed() {
    take();
    if (ended_ && !line_) {
      throw ArgumentError(
          "The input ended before Enter said that the weight hangs. The old setting is kept. Run "
          "it at a terminal.");
    }
    return line_;
  }

 private:
  bool take() {
    pollfd input{.fd = STDIN_FILENO, .events = POLLIN, .revents = 0};
    if (poll(&input, 1, 0) <= 0) return false;
    std::array<char, 64> bytes{};
    const ssize_t size = ::read(STDIN_FILENO, bytes.data(), bytes.size());
    ended_ = size <= 0;
    line_ = line_ || std::find(bytes.begin(), bytes.end(), '\n') != bytes.end();
    return true;
  }

  bool line_ = false, ended_ = false;
};

std::string promptOf(const falcon::Calibration& calibration) {
  return calibration.phase() == falcon::Calibration::Phase::hang_weight
             ? "Hang the weight on the grip, let it come to rest, then press Enter."
             : calibration.prompt();
}

}  // namespace

Outcome falconSelfTest(const SelfTestArguments& a, const Task& task) {
  const auto device = openFalcon(falcon::readSettings(falcon::settingsFile()));
  waitUntilReady(*device, a.ready_s, task);
  falcon::SelfTest test(
      *device, {.rate_s = a.rate_s, .nudges = !a.no_nudges, .wait_for_person_s = a.wait_s});
  std::string told;
  std::int64_t deadline = monotonicNs();
  while (test.step(monotonicNs())) {
    if (test.prompt() != told) tell(told = test.prompt());
    deadline = std::max(deadline + kMs, monotonicNs());
    tickUntil(deadline, task);
  }
  Json json;
  Outcome outcome;
  json["passed"] = test.passed();
  json["lines"] = Json::array();
  for (const falcon::SelfTestLine& line : test.lines()) {
    constexpr std::array<const char*, 3> kResults{"passed", "failed", "not seen"};
    const char* result = kResults[static_cast<std::size_t>(line.result)];
    json["lines"].push_back({{"result", result}, {"text", line.text}});
    outcome.lines.push_back(std::string(result) + ": " + line.text);
  }
  outcome.lines.push_back(test.prompt());
  outcome.json = json.dump(2);
  outcome.exit_code = test.passed() ? 0 : kDeviceExit;
  return outcome;
}

Outcome calibrateFalcon(double weight_g, double ready_s, const Task& task) {
  falcon::FalconSettings settings = falcon::readSettings(falcon::settingsFile());
  const double before = settings.counts_per_n_mm;
  const auto device = openFalcon(settings);
  waitUntilReady(*device, ready_s, task);
  falcon::Calibration calibration(*device, before, weight_g);
  std::unique_ptr<EnterKey> enter;
  std::string told;
  std::int64_t deadline = monotonicNs();
  while (calibration.step(monotonicNs())) {
    const std::string prompt = promptOf(calibration);
    if (prompt != told) tell(told = prompt);
    if (calibration.phase() == falcon::Calibration::Phase::hang_weight) {
      if (!enter) enter = std::make_unique<EnterKey>();
      if (enter->pressed()) calibration.weightHangs();
    }
    deadline = std::max(deadline + kMs, monotonicNs());
    tickUntil(deadline, task);
  }
  device->close();
  if (!calibration.result()) throw DeviceError(calibration.prompt());
  settings = falcon::readSettings(falcon::settingsFile());
  settings.counts_per_n_mm = *calibration.result();
  falcon::writeSettings(settings, falcon::settingsFile());
  std::array<char, 120> line{};
  std::snprintf(line.data(), line.size(),
                "The force is calibrated: %.2f counts per N mm, %.2f before.",
                settings.counts_per_n_mm, before);
  const Json json{{"counts_per_n_mm", settings.counts_per_n_mm},
                  {"before", before},
                  {"settings", falcon::settingsFile().string()}};
  return {.json = json.dump(2),
          .lines = {line.data(), "kept in " + falcon::settingsFile().string()}};
}

Outcome setLeftHanded(bool left_handed) {
  falcon::FalconSettings settings = falcon::readSettings(falcon::settingsFile());
  settings.left_handed = left_handed;
  falcon::writeSettings(settings, falcon::settingsFile());
  return {.json = Json{{"left_handed", left_handed}}.dump(2),
          .lines = {left_handed ? "Left-handed: plus and minus change sides."
                                : "Right-handed: plus and minus are where the grip has them.",
                    "kept in " + falcon::settingsFile().string()}};
}

}  // namespace relievo::batch
