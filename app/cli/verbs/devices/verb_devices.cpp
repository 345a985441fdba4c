// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "app/cli/json.h"
#include "app/cli/options/number_option.h"
#include "app/cli/report_text.h"
#include "app/cli/verb.h"
#include "app/cli/verbs/devices/live_device.h"
#include "app/cli/verbs/devices/verb_devices_falcon.h"
#include "app/cli/verbs/devices/verb_devices_haply.h"
#include "app/cli/verbs/devices/verb_devices_plugins.h"
#include "core/base/failure.h"
#include "haptics/device/falcon/falcon_device.h"
#include "haptics/device/falcon/firmware.h"
#include "haptics/device/falcon/link/link_status.h"
#include "haptics/device/falcon/presence.h"
#include "haptics/device/falcon/settings_file.h"
#include "haptics/device/falcon/usb_bus.h"
#include "haptics/device/hid/hid_devices.h"
#include "haptics/device/pad/pad_devices.h"
#include "haptics/device_catalog.h"

namespace relievo::batch {
namespace {

constexpr int kUnreadableExit = 2;

struct DevicesArguments {
  std::string file, hand;
  bool accept = false;
  double weight_g = 0;
  SelfTestArguments test;
  PluginArguments plugin;
  LibraryArguments library;
  bool firmware = false, selftest = false, calibrate = false, rule = false;
};

falcon::FirmwarePlaces firmwarePlacesNow() {
  return falcon::firmwarePlaces(falcon::readSettings(falcon::settingsFile()).firmware);
}

Json jsonOfFirmware(const falcon::Firmware& firmware) {
  return {{"file", firmware.file.string()},
          {"bytes", firmware.bytes.size()},
          {"sha256", firmware.sha256},
          {"known_as", firmware.known_as ? Json(englishText(*firmware.known_as)) : Json()}};
}

/// SpaceMouse, foot switches and gamepads. They only press: one that is closed fails nothing.
void listHid(Json& json, std::vector<std::string>& lines) {
  json["hid"] = Json::array();
  try {
    hid::HidDevices devices;
    hid::HidEvents ignored;
    devices.rescan(ignored);
    for (const std::string& name : devices.names()) {
      json["hid"].push_back({{"name", name}, {"access", true}});
      lines.push_back("HID: " + name);
    }
    for (const std::string& name : devices.forbidden()) {
      json["hid"].push_back({{"name", name}, {"access", false}});
      lines.push_back("HID: " + name + " (no access)");
      tell(name +
           " is plugged in but this account may not use it. Install the rule that 'relievo "
           "devices rule' prints, once (needs an administrator), then replug.");
    }
  } catch (const DeviceError& error) {
    tell(error.what());
  }
}

/// Those that press by event devices, and all that rumble.
void listPads(Json& json, std::vector<std::string>& lines) {
  json["pads"] = Json::array();
  if (!pad::hasPadDevices()) return tell(englishText(said<MessageId::pads_not_built>()));
  pad::PadDevices devices;
  pad::PadNews ignored;
  devices.rescan(ignored);
  for (const pad::SeenPad& seen : devices.seen()) {
    json["pads"].push_back({{"name", seen.name},
                            {"access", seen.access},
                            {"buttons", seen.presses},
                            {"rumble", seen.can_rumble}});
    std::string line = "Gamepad: " + seen.name;
    if (seen.presses) line += ", buttons";
    if (seen.can_rumble) line += ", rumble as a cue, no force";
    lines.push_back(line + (seen.access ? "" : " (no access)"));
  }
}

/// A file that the user named and that is bad is always told; that there is none, if a Falcon is.
void listFirmware(Json& json, CommandResult& outcome) {
  const falcon::FirmwarePlaces places = firmwarePlacesNow();
  try {
    json["falcon_firmware"] = jsonOfFirmware(falcon::findFirmware(places));
    outcome.lines.push_back("Falcon firmware: " +
                            json["falcon_firmware"]["file"].get<std::string>());
  } catch (const FileError& error) {
    const bool named = !places.setting.empty() || !places.environment.empty();
    json["falcon_firmware"] = nullptr;
    outcome.lines.emplace_back(named ? "Falcon firmware: the file that was named cannot be used"
                                     : "Falcon firmware: none found");
    if (named && outcome.exit_code == 0) outcome.exit_code = kUnreadableExit;
    if (named) {
      tell(error.what());
    } else if (!json["falcons"].empty()) {
      // Whether it needs one is not asked here: that would take it from whoever uses it.
      tell(
          "No firmware file for the Falcon was found. One whose firmware is running already needs "
          "none; for any other, run 'relievo devices firmware FILE' with the file "
          "nvent_firmware.bin (8492 bytes) from your Novint software or libnifalcon.");
    }
  }
}

/// Each by its serial number and port, however many there are and whoever uses them.
void listFalcons(Json& json, CommandResult& outcome) {
  json["falcons"] = Json::array();
  const std::vector<falcon::SeenFalcon> all = falcon::seenFalcons();
  if (const std::string problem = falcon::libusbProblem(); !problem.empty()) {
    tell(englishText(said<MessageId::usb_not_usable>(problem)));
  }
  for (const falcon::SeenFalcon& seen : all) {
    falcon::UsbBus bus({seen.serial, seen.port});
    const falcon::Opening opening = bus.open();
    constexpr std::array<const char*, 6> kNames{"present", "absent", "forbidden",
                                                "busy",    "broken", "several"};
    const char* const presence = kNames[static_cast<std::size_t>(opening.presence)];
    const Message message = falcon::describe(opening);
    const std::string code = codeOf(message);
    const std::string id = idOf(shortestChoice(seen, all));
    const falcon::FalconSettings settings =
        falcon::readSettings(falcon::settingsFile(), seen.serial);
    json["falcons"].push_back({{"id", id},
                               {"serial", seen.serial.empty() ? Json() : Json(seen.serial)},
                               {"port", seen.port},
                               {"bus", seen.bus},
                               {"address", seen.address},
                               {"presence", presence},
                               {"code", code},
                               {"counts_per_n_mm", settings.counts_per_n_mm},
                               {"grip_weight_n", settings.grip_weight_n}});
    outcome.lines.push_back(id + ": serial number " +
                            (seen.serial.empty() ? std::string("none") : seen.serial) +
                            ", USB port " + seen.port + ", " + presence);
    if (opening.presence == falcon::Presence::present) continue;
    outcome.exit_code = kDeviceExit;
    tell((code.empty() ? "" : code + ": ") + englishText(message));
  }
}

/// Also of a kind that is not plugged in: before somebody buys one.
void tellTried(const std::string& kind, const std::string& tried, Json& json,
               std::vector<std::string>& lines) {
  if (tried.empty()) return;
  json["tried_on_hardware"][kind] = tried;
  lines.push_back(kind + ": tried on hardware: " + tried);
}

CommandResult list(const Task& task) {
  Json json;
  json["devices"] = Json::array();
  json["tried_on_hardware"] = Json::object();
  CommandResult outcome;
  for (const DeviceDriver& driver : deviceCatalog()) {
    tellTried(driver.kind, driver.tried_on_hardware, json, outcome.lines);
    for (const std::string& id : driver.scan()) {
      const std::unique_ptr<Device> device = driver.make(id);
      const DeviceInfo& info = device->info();
      json["devices"].push_back(
          {{"id", id}, {"name", info.name}, {"max_force_n", info.max_force_n}});
      outcome.lines.push_back(id + ": " + info.name +
                              (info.max_force_n > 0 ? "" : " (cannot push back)"));
    }
  }
  for (const OwnPlugin& plugin : kOwnPlugins) {
    tellTried(std::string(plugin.file), std::string(plugin.tried_on_hardware), json, outcome.lines);
  }
  listPlugins(json, outcome, task);
  listHid(json, outcome.lines);
  listPads(json, outcome.lines);
  listHaplys(json, outcome);
  listFalcons(json, outcome);
  listFirmware(json, outcome);
  const falcon::FalconSettings settings = falcon::readSettings(falcon::settingsFile());
  json["falcon_settings"] = {{"counts_per_n_mm", settings.counts_per_n_mm},
                             {"left_handed", settings.left_handed}};
  outcome.json = reportText(json);
  return outcome;
}

/// Says which file goes before the installed one, if any does. @return its name
std::string firmwareInstead(const std::filesystem::path& installed) {
  const falcon::FirmwarePlaces places = firmwarePlacesNow();
  std::string named = places.setting.empty() ? places.environment : places.setting.string();
  if (named.empty()) return {};
  try {
    std::error_code ignored;
    if (std::filesystem::equivalent(falcon::findFirmware(places).file, installed, ignored)) {
      return {};
    }
  } catch (const FileError&) {
    // It goes first all the same, and fails.
  }
  tell(places.setting.empty()
           ? "RELIEVO_FALCON_FIRMWARE names \"" + named +
                 "\", which is used instead. Unset it to use the installed file."
           : "The setting in \"" + falcon::settingsFile().string() + "\" names \"" + named +
                 "\", which is used instead. Clear it (Preferences > Device) to use the "
                 "installed file.");
  return named;
}

CommandResult installFirmware(const DevicesArguments& a) {
  const falcon::Firmware firmware = falcon::readFirmware(a.file);
  const falcon::FirmwarePlaces places = falcon::firmwarePlaces();
  if (!falcon::isAccepted(firmware, places) && !a.accept) {
    throw failure<MessageId::firmware_not_installed>(a.file, firmware.sha256);
  }
  Json json = jsonOfFirmware(firmware);
  const std::filesystem::path installed = falcon::installFirmware(firmware, places);
  json["installed"] = installed.string();
  const std::string overriding = firmwareInstead(installed);
  json["overridden_by"] = overriding.empty() ? Json() : Json(overriding);
  return {.json = reportText(json),
          .lines = {(firmware.known_as ? englishText(*firmware.known_as) : "Unknown image") + ", " +
                        std::to_string(firmware.bytes.size()) + " bytes",
                    "sha256 " + firmware.sha256,
                    "installed as " + json["installed"].get<std::string>()}};
}

}  // namespace

namespace {
void declareFalcon(CLI::App& verb, const std::shared_ptr<DevicesArguments>& a) {
  const auto until_ready = [&a](CLI::App& falcon) {
    takes(falcon.add_option("--ready", a->test.ready_s, "Seconds until it must be homed"),
          {.low = 1, .high = 600, .unit = "s"});
    falcon.add_option("--device", a->test.device, "falcon:SERIAL, if there are several");
  };
  CLI::App* selftest = verb.add_subcommand(
      "selftest", "Rate, lights, nudges of 0.5 N; buttons and encoders with --wait");
  selftest->add_flag("--no-nudges", a->test.no_nudges, "Leave the motors at zero force");
  takes(selftest->add_option("--seconds", a->test.rate_s, "How long the rate is measured; 2"),
        {.low = 0.5, .high = 3600, .unit = "s"});
  takes(selftest->add_option("--wait", a->test.wait_s, "Seconds for you to press and move"),
        {.low = 0, .high = 600, .unit = "s"});
  until_ready(*selftest);
  selftest->callback([a] { a->selftest = true; });
  CLI::App* calibrate = verb.add_subcommand(
      "calibrate", "The Falcon's force by a known weight that you hang on its grip");
  takes(calibrate->add_option("--weight", a->weight_g, "Grams, 20 to 300"),
        {.low = 20, .high = 300, .unit = "g"})
      .required();
  until_ready(*calibrate);
  calibrate->callback([a] { a->calibrate = true; });
  verb.add_option("--left-handed", a->hand, "Plus and minus change sides: yes or no; kept")
      ->check(CLI::IsMember({"yes", "no"}));
}
std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

}  // namespace

Verb devicesVerb() {
  auto a = std::make_shared<DevicesArguments>();
  return {.name = "devices",
          .help = "Haptic devices: list them; the Falcon's firmware, self test, force, hand",
          .declare =
              [a](CLI::App& verb) {
                // --report may stand behind the second word as well.
                verb.fallthrough();
                CLI::App* firmware = verb.add_subcommand(
                    "firmware", "Check a firmware file of Novint's and install it for this user");
                firmware->add_option("FILE", a->file, "Such as nvent_firmware.bin")->required();
                firmware->add_flag("--accept", a->accept, "Install an image that nobody knows");
                firmware->callback([a] { a->firmware = true; });
                declareFalcon(verb, a);
                declarePlugins(verb, a->plugin);
                declareLibrary(verb, a->library);
                verb.add_subcommand("rule", "Print the udev rule that gives access (E301)")
                    ->callback([a] { a->rule = true; });
                verb.require_subcommand(0, 1);
              },
          .run =
              [a](const Task& task) {
                CommandResult hand;
                if (!a->hand.empty()) hand = setLeftHanded(a->hand == "yes");
                if (a->firmware) return installFirmware(*a);
                if (a->selftest) return falconSelfTest(a->test, task);
                if (a->calibrate) return calibrateFalcon(a->weight_g, a->test, task);
                if (a->rule) {
                  return CommandResult{.json = Json{{"rule", falcon::udevRule()}}.dump(2),
                                       .lines = linesOf(falcon::udevRule())};
                }
                if (a->library.asked) return makersLibraryOf(a->library);
                if (!a->plugin.trust.empty()) return trustPluginFile(a->plugin.trust);
                if (!a->plugin.distrust.empty()) return distrustPluginFile(a->plugin.distrust);
                if (!a->plugin.conformance.empty()) return checkPluginFile(a->plugin, task);
                return a->hand.empty() ? list(task) : hand;
              }};
}

}  // namespace relievo::batch
