// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/device/haply/device_search.h"

#include <algorithm>
#include <vector>

namespace relievo::haply {

namespace {
constexpr std::string_view kKind = "haply";
constexpr std::int64_t kLookNs = 100'000'000;  // At the stop token.

LinkState stateOf(Reached reached) {
  switch (reached) {
    case Reached::connected:
      return LinkState::ready;
    case Reached::absent:
      return LinkState::no_service;
    case Reached::other:
      return LinkState::other_service;
    case Reached::too_old:
      break;
  }
  return LinkState::old_service;
}
}  // namespace

std::optional<std::string> chosenBy(std::string_view id) {
  if (id == kKind) return std::string();
  if (!id.starts_with(kKind) || id.size() < kKind.size() + 2 || id[kKind.size()] != ':') {
    return std::nullopt;
  }
  id.remove_prefix(kKind.size() + 1);
  if (id.size() > ShortText::kMost) return std::nullopt;
  return std::string(id);
}

std::string idOf(std::string_view chosen) {
  std::string id(kKind);
  return chosen.empty() ? id : id.append(":").append(chosen);
}

Inventory lookAround(Service& service, const std::stop_token& stop) {
  Inventory inventory;
  Connection connection = service.connect(stop);
  inventory.state = stateOf(connection.reached);
  inventory.version = connection.version;
  inventory.detail = std::move(connection.detail);
  if (inventory.state != LinkState::ready) return inventory;
  const std::int64_t give_up = service.now() + service.patienceNs();
  Port::Incoming first;
  while (first.result == PortResult::timeout && service.now() < give_up && !stop.stop_requested()) {
    first = connection.port->receive(std::min(service.now() + kLookNs, give_up));
  }
  if (first.result == PortResult::ok && readState(first.text, inventory.seen)) {
    inventory.port = std::move(connection.port);
  } else {
    inventory.state = LinkState::other_service;
    inventory.detail = first.result == PortResult::ok ? "no inventory" : "no answer";
  }
  return inventory;
}

Choice choose(const Inventory& inventory, const Service& service, std::string_view chosen) {
  Choice choice;
  LinkStatus& status = choice.status;
  status.state = inventory.state;
  status.version = inventory.version.text;
  put(service.address(), status.address);
  put(inventory.detail, status.detail);
  if (!chosen.empty()) put(nameOf("", chosen), status.wanted);
  if (inventory.state != LinkState::ready) return choice;
  std::vector<std::string> ids;
  for (const ServiceDevice& device : inventory.seen.told()) {
    ids.emplace_back(device.id.view());
    if (chosen.empty() || device.id.view() == chosen) choice.device = &device;
  }
  status.state = LinkState::checking;
  if (chosen.empty() && ids.size() > 1) {
    choice.device = nullptr;
    status.state = LinkState::several;
  } else if (choice.device == nullptr) {
    status.state = LinkState::no_device;
  } else {
    status.id = choice.device->id;
    status.type = choice.device->type;
    return choice;
  }
  std::sort(ids.begin(), ids.end());
  std::string names;
  for (const std::string& id : ids) names += (names.empty() ? "" : ", ") + id;
  put(names, status.others);
  return choice;
}

LinkState stateOf(const ServiceDevice& device) noexcept {
  if (!device.power_supply) return LinkState::no_power;
  if (!device.started || !device.ready) return LinkState::not_started;
  return device.calibrated ? LinkState::ready : LinkState::not_calibrated;
}

DeviceInfo limitsOf(std::string_view type) {
  const bool large = type == "inverse3" || type == "inverse3x";
  DeviceInfo info;
  info.workspace.half_extent = large ? DeviceMm{70, 50, 50} : DeviceMm{28, 20, 20};
  info.max_force_n = large ? 5 : 2;
  info.max_stiffness_n_per_mm = large ? 0.6 : 0.4;
  // As the Falcon's, until somebody has measured another.
  info.max_damping_n_s_per_mm = 0.006;
  info.max_slew_n_per_s = 200;
  info.position_step_mm = 0.05;
  info.force_delay_ticks = 2;  // Up to one until it is sent, one until the service shows it.
  return info;
}

}  // namespace relievo::haply
