// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>
#include <memory>

#include "app/batch/json.h"
#include "app/batch/verb.h"
#include "haptics/device/falcon/falcon_device.h"
#include "haptics/device/falcon/firmware.h"
#include "haptics/device/falcon/link_status.h"
#include "haptics/device/falcon/self_test.h"
#include "haptics/device/falcon/settings_file.h"
#include "haptics/device/falcon/usb_bus.h"
#include "haptics/device_catalog.h"
#include "haptics/rt/realtime_thread.h"

namespace relievo::batch {
namespace {

constexpr int kDeviceExit = 6;
constexpr std::int64_t kMs = 1'000'000;

struct DevicesArguments {
  std::string file;
  bool accept = false, no_nudges = false;
  double wait_s = 0, ready_s = 60;
  bool firmware = false, selftest = false, rule = false;
};

Json jsonOfFirmware(const falcon::Firmware& firmware) {
  return {{"file", firmware.file.string()},
          {"bytes", firmware.bytes.size()},
          {"sha256", firmware.sha256},
          {"known_as", firmware.known_as.empty() ? Json() : Json(firmware.known_as)}};
}

/// Waits a tick; forwards Ctrl+C.
void tickUntil(std::int64_t deadline_ns, const Task& task) {
  task.check();
  sleepUntil(deadline_ns);
}

/// Tells every new state on stderr until the Falcon is ready.
/// @throw DeviceError  it is not, and why
void waitUntilReady(falcon::FalconDevice& device, double seconds, const Task& task) {
  std::string told;
  const std::int64_t give_up = monotonicNs() + static_cast<std::int64_t>(1e9 * seconds);
  while (true) {
    const falcon::LinkStatus& status = device.status();
    const falcon::LinkMessage message = falcon::describe(status);
    if (status.state == falcon::LinkState::ready) return;
    const bool hopeless = status.state == falcon::LinkState::no_firmware ||
                          status.state == falcon::LinkState::not_started ||
                          status.state == falcon::LinkState::absent;
    if (hopeless || monotonicNs() > give_up) throw DeviceError(message.screen, message.code);
    if (status.state != falcon::LinkState::closed && message.screen != told) {
      told = message.screen;
      tell(message.code.empty() ? told : message.code + ": " + told);
    }
    tickUntil(monotonicNs() + 20 * kMs, task);
  }
}

Outcome list() {
  Json json;
  json["devices"] = Json::array();
  Outcome outcome;
  for (const DeviceDriver& driver : deviceCatalog()) {
    for (const std::string& id : driver.scan()) {
      const std::unique_ptr<Device> device = driver.make(id);
      const DeviceInfo& info = device->info();
      json["devices"].push_back(
          {{"id", id}, {"name", info.name}, {"max_force_n", info.max_force_n}});
      outcome.lines.push_back(id + ": " + info.name +
                              (info.max_force_n > 0 ? "" : " (cannot push back)"));
    }
  }
  json["falcons"] = Json::array();
  for (const falcon::SeenFalcon& seen : falcon::seenFalcons()) {
    falcon::UsbBus bus;
    const falcon::Opening opening = bus.open();
    falcon::LinkStatus status;
    constexpr std::array<falcon::LinkState, 5> kStates{
        falcon::LinkState::closed, falcon::LinkState::absent, falcon::LinkState::forbidden,
        falcon::LinkState::busy, falcon::LinkState::broken};
    constexpr std::array<const char*, 5> kNames{"present", "absent", "forbidden", "busy", "broken"};
    const auto presence = static_cast<std::size_t>(opening.presence);
    status.state = kStates[presence];
    const falcon::LinkMessage message = falcon::describe(status);
    json["falcons"].push_back({{"bus", seen.bus},
                               {"address", seen.address},
                               {"presence", kNames[presence]},
                               {"code", message.code}});
    if (opening.presence == falcon::Presence::present) continue;
    outcome.exit_code = kDeviceExit;
    tell((message.code.empty() ? "" : message.code + ": ") + message.screen);
  }
  try {
    json["falcon_firmware"] = jsonOfFirmware(falcon::findFirmware(
        falcon::firmwarePlaces(falcon::readSettings(falcon::settingsFile()).firmware)));
    outcome.lines.push_back("Falcon firmware: " +
                            json["falcon_firmware"]["file"].get<std::string>());
  } catch (const FileError& error) {
    json["falcon_firmware"] = nullptr;
    outcome.lines.emplace_back("Falcon firmware: none found");
    if (!json["falcons"].empty()) tell(error.what());
  }
  outcome.json = json.dump(2);
  return outcome;
}

Outcome installFirmware(const DevicesArguments& a) {
  const falcon::Firmware firmware = falcon::readFirmware(a.file);
  const falcon::FirmwarePlaces places = falcon::firmwarePlaces();
  if (!falcon::isAccepted(firmware, places) && !a.accept) {
    throw ArgumentError("\"" + a.file +
                        "\" has the form of a boot image, but nobody knows this "
                        "one (sha256 " +
                        firmware.sha256 +
                        "). Nothing was installed. Add --accept if you trust it.");
  }
  Json json = jsonOfFirmware(firmware);
  json["installed"] = falcon::installFirmware(firmware, places).string();
  return {.json = json.dump(2),
          .lines = {(firmware.known_as.empty() ? "Unknown image" : firmware.known_as) + ", " +
                        std::to_string(firmware.bytes.size()) + " bytes",
                    "sha256 " + firmware.sha256,
                    "installed as " + json["installed"].get<std::string>()}};
}

Outcome selftest(const DevicesArguments& a, const Task& task) {
  falcon::FalconDevice device(std::make_unique<falcon::UsbBus>(), falcon::storedFirmwareSource(),
                              falcon::readSettings(falcon::settingsFile()));
  device.open();
  waitUntilReady(device, a.ready_s, task);
  falcon::SelfTest test(device, {.nudges = !a.no_nudges, .wait_for_person_s = a.wait_s});
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

}  // namespace

Verb devicesVerb() {
  auto a = std::make_shared<DevicesArguments>();
  return {.name = "devices",
          .help = "Haptic devices: list them, install the Falcon's firmware, self test",
          .declare =
              [a](CLI::App& verb) {
                // --report may stand behind the second word as well.
                verb.fallthrough();
                CLI::App* firmware = verb.add_subcommand(
                    "firmware", "Check a firmware file of Novint's and install it for this user");
                firmware->add_option("FILE", a->file, "Such as nvent_firmware.bin")->required();
                firmware->add_flag("--accept", a->accept, "Install an image that nobody knows");
                firmware->callback([a] { a->firmware = true; });
                CLI::App* selftest = verb.add_subcommand(
                    "selftest", "Rate, lights, nudges of 0.5 N; buttons and encoders with --wait");
                selftest->add_flag("--no-nudges", a->no_nudges, "Leave the motors at zero force");
                selftest->add_option("--wait", a->wait_s, "Seconds for you to press and move")
                    ->check(CLI::Range(0.0, 600.0));
                selftest->add_option("--ready", a->ready_s, "Seconds until it must be homed")
                    ->check(CLI::Range(1.0, 600.0));
                selftest->callback([a] { a->selftest = true; });
                verb.add_subcommand("rule", "Print the udev rule that gives access (E301)")
                    ->callback([a] { a->rule = true; });
                verb.require_subcommand(0, 1);
              },
          .run =
              [a](const Task& task) {
                if (a->firmware) return installFirmware(*a);
                if (a->selftest) return selftest(*a, task);
                if (a->rule) {
                  return Outcome{.json = Json{{"rule", falcon::udevRule()}}.dump(2),
                                 .lines = {falcon::udevRule()}};
                }
                return list();
              }};
}

}  // namespace relievo::batch
