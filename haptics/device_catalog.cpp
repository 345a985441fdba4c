// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/device_catalog.h"

#include <algorithm>
#include <string_view>

#include "core/base/failure.h"
#include "haptics/device/falcon/falcon_device.h"
#include "haptics/device/falcon/settings_file.h"
#include "haptics/device/falcon/usb_bus.h"
#include "haptics/device/foreign/plugin_files.h"
#include "haptics/device/haply/haply_device.h"
#include "haptics/device/haply/service_address.h"
#include "haptics/device/mouse_device.h"
#include "haptics/device/virtual_hand.h"

namespace relievo {

namespace {
constexpr std::string_view kVirtual = "virtual";

std::vector<std::string> virtualHands() {
  std::vector<std::string> ids;
  for (const HandImpedance& preset : kHandPresets) {
    ids.push_back(std::string(kVirtual) + ":" + std::string(preset.name));
  }
  return ids;
}

std::unique_ptr<Device> makeVirtualHand(const std::string& id) {
  if (id == kVirtual) return std::make_unique<VirtualHand>();
  return std::make_unique<VirtualHand>(virtualHandNamed(id.substr(kVirtual.size() + 1)));
}

std::vector<std::string> falcons() {
  const std::vector<falcon::SeenFalcon> seen = falcon::seenFalcons();
  std::vector<std::string> ids;
  for (const falcon::SeenFalcon& one : seen) ids.push_back(idOf(shortestChoice(one, seen)));
  return ids;
}

std::unique_ptr<Device> makeFalcon(const std::string& id) {
  const auto named = falcon::falconChoice(id);
  if (!named) {
    throw failure<MessageId::falcon_id_unknown>(id);
  }
  const falcon::FalconChoice choice = falcon::settled(*named);
  return std::make_unique<falcon::FalconDevice>(
      std::make_unique<falcon::UsbBus>(choice), falcon::storedFirmwareSource(),
      falcon::readSettings(falcon::settingsFile(), choice.serial));
}

/// Somebody listens where its service does; who and what they see is asked when it is opened.
std::vector<std::string> haplys() {
  if (!haply::isServiceThere()) return {};
  return {"haply"};
}

std::unique_ptr<Device> makeHaply(const std::string& id) {
  auto chosen = haply::chosenBy(id);
  if (!chosen) throw failure<MessageId::haply_id_unknown>(id);
  return std::make_unique<haply::HaplyDevice>(haply::inverseService(haply::serviceAddress()),
                                              *std::move(chosen));
}
}  // namespace

std::vector<DeviceDriver> deviceCatalog() {
  return {{"mouse", [] { return std::vector<std::string>{"mouse"}; },
           [](const std::string& id) -> std::unique_ptr<Device> {
             if (id != "mouse") throw failure<MessageId::no_mouse_device>(id);
             return std::make_unique<MouseDevice>();
           }},
          {std::string(kVirtual), virtualHands, makeVirtualHand},
          {"falcon", falcons, makeFalcon, "never"},
          {"haply", haplys, makeHaply, "never"}};
}

std::optional<std::string> triedOnHardware(std::string_view id) {
  const std::string_view kind = id.substr(0, id.find(':'));
  if (kind != foreign::kPluginKind) {
    for (const DeviceDriver& driver : deviceCatalog()) {
      if (kind == driver.kind) return driver.tried_on_hardware;
    }
    return "";
  }
  const std::string_view rest = id.substr(std::min(id.size(), kind.size() + 1));
  for (const OwnPlugin& plugin : kOwnPlugins) {
    if (rest.substr(0, rest.find('/')) == plugin.file) return std::string(plugin.tried_on_hardware);
  }
  return {};
}

std::unique_ptr<Device> makeDevice(const std::string& id) {
  std::string known;
  for (const DeviceDriver& driver : deviceCatalog()) {
    if (id == driver.kind || id.starts_with(driver.kind + ":")) return driver.make(id);
    known += driver.kind + ", ";
  }
  // No driver of this build, and never looked for without being asked: to look is to run them.
  const std::string plugin = foreign::kPluginKind;
  if (id == plugin || id.starts_with(plugin + ":")) return foreign::makePluginDevice(id);
  known += plugin;
  throw failure<MessageId::device_unknown>(id, known);
}

}  // namespace relievo
