// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/verbs/devices/verb_devices_falcon.h"

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <memory>

#include "app/cli/json.h"
#include "app/cli/report_text.h"
#include "app/cli/verbs/devices/live_device.h"
#include "core/base/failure.h"
#include "haptics/device/falcon/calibration.h"
#include "haptics/device/falcon/falcon_device.h"
#include "haptics/device/falcon/self_test.h"
#include "haptics/device/falcon/settings_file.h"
#include "haptics/device/falcon/usb_bus.h"
#include "haptics/rt/realtime_thread.h"

namespace relievo::batch {
namespace {

constexpr std::int64_t kMs = 1'000'000;
constexpr const char* kNothingTried = "nothing was tried";

/// Waits a tick; forwards Ctrl+C.
void tickUntil(std::int64_t deadline_ns, const Task& task) {
  task.check();
  sleepUntil(deadline_ns);
}

falcon::FalconChoice choiceOf(const std::string& id) {
  const auto choice = falcon::falconChoice(id);
  if (!choice) {
    throw failure<MessageId::device_not_tried>(id);
  }
  return falcon::settled(*choice);
}

std::unique_ptr<falcon::FalconDevice> openFalcon(const falcon::FalconChoice& choice,
                                                 const falcon::FalconSettings& settings) {
  auto device = std::make_unique<falcon::FalconDevice>(std::make_unique<falcon::UsbBus>(choice),
                                                       falcon::storedFirmwareSource(), settings);
  device->open();
  return device;
}

/// @throw DeviceError  the computer is about to sleep; the motors are at zero
template <MessageId why>
void endIfAsleep(EndBeforeSleep& sleep, falcon::FalconDevice& device) {
  if (!sleep.wanted()) return;
  device.close();
  sleep.atZero();
  throw failure<why>();
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
      throw failure<MessageId::calibration_input_ended>();
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
             : englishText(calibration.prompt());
}

}  // namespace

CommandResult falconSelfTest(const SelfTestArguments& a, const Task& task) {
  const falcon::FalconChoice choice = choiceOf(a.device);
  const auto device =
      openFalcon(choice, falcon::readSettings(falcon::settingsFile(), choice.serial));
  waitUntilReady(*device, a.ready_s, kNothingTried, task);
  falcon::SelfTest test(
      *device, {.rate_s = a.rate_s, .nudges = !a.no_nudges, .wait_for_person_s = a.wait_s});
  EndBeforeSleep sleep;
  std::string told;
  std::int64_t deadline = monotonicNs();
  while (test.step(monotonicNs())) {
    endIfAsleep<MessageId::computer_sleeps>(sleep, *device);
    if (const std::string prompt = englishText(test.prompt()); prompt != told) {
      tell(told = prompt);
    }
    deadline = std::max(deadline + kMs, monotonicNs());
    tickUntil(deadline, task);
  }
  Json json;
  CommandResult outcome;
  json["device"] = device->info().id;
  json["device_name"] = device->info().name;
  json["passed"] = test.passed();
  json["lines"] = Json::array();
  for (const falcon::SelfTestLine& line : test.lines()) {
    constexpr std::array<const char*, 3> kResults{"passed", "failed", "not seen"};
    const char* result = kResults[static_cast<std::size_t>(line.result)];
    json["lines"].push_back({{"result", result}, {"text", englishText(line.text)}});
    outcome.lines.push_back(std::string(result) + ": " + englishText(line.text));
  }
  outcome.lines.push_back(englishText(test.prompt()));
  outcome.json = reportText(json);
  outcome.exit_code = test.passed() ? 0 : kDeviceExit;
  return outcome;
}

CommandResult calibrateFalcon(double weight_g, const SelfTestArguments& which, const Task& task) {
  const falcon::FalconChoice choice = choiceOf(which.device);
  falcon::FalconSettings settings = falcon::readSettings(falcon::settingsFile(), choice.serial);
  const double before = settings.counts_per_n_mm;
  const auto device = openFalcon(choice, settings);
  waitUntilReady(*device, which.ready_s, kNothingTried, task);
  falcon::Calibration calibration(*device, before, weight_g);
  std::unique_ptr<EnterKey> enter;
  std::string told;
  std::int64_t deadline = monotonicNs();
  EndBeforeSleep sleep;
  while (calibration.step(monotonicNs())) {
    endIfAsleep<MessageId::computer_sleeps_setting_kept>(sleep, *device);
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
  if (!calibration.result()) {
    const Message message = calibration.prompt();
    throw DeviceError(message);
  }
  const std::string serial = device->status().serial.data();
  settings = falcon::readSettings(falcon::settingsFile(), serial);
  settings.counts_per_n_mm = *calibration.result();
  settings.grip_weight_n = calibration.gripWeightN();
  falcon::writeSettings(settings, falcon::settingsFile(), serial);
  std::array<char, 160> line{};
  std::snprintf(
      line.data(), line.size(),
      "The force is calibrated: %.2f counts per N mm, %.2f before; the grip weighs %.2f N.",
      settings.counts_per_n_mm, before, settings.grip_weight_n);
  const Json json{{"device", device->info().id},
                  {"device_name", device->info().name},
                  {"counts_per_n_mm", settings.counts_per_n_mm},
                  {"before", before},
                  {"grip_weight_n", settings.grip_weight_n},
                  {"settings", falcon::settingsFile().string()}};
  return {.json = reportText(json),
          .lines = {line.data(), "kept in " + falcon::settingsFile().string()}};
}

CommandResult setLeftHanded(bool left_handed) {
  falcon::FalconSettings settings = falcon::readSettings(falcon::settingsFile());
  settings.left_handed = left_handed;
  falcon::writeSettings(settings, falcon::settingsFile());
  return {.json = Json{{"left_handed", left_handed}}.dump(2),
          .lines = {left_handed ? "Left-handed: plus and minus change sides."
                                : "Right-handed: plus and minus are where the grip has them.",
                    "kept in " + falcon::settingsFile().string()}};
}

}  // namespace relievo::batch
