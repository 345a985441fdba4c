// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/verbs/devices/verb_devices_haply.h"

#include <memory>
#include <string>

#include "app/cli/verbs/devices/live_device.h"
#include "core/base/error.h"
#include "haptics/device/haply/device_search.h"
#include "haptics/device/haply/service_address.h"

namespace relievo::batch {

namespace {
void tellMessage(const Message& message) {
  const std::string code = codeOf(message);
  tell((code.empty() ? "" : code + ": ") + englishText(message));
}

void listOne(const haply::ServiceDevice& device, Json& json, CommandResult& outcome) {
  haply::LinkStatus status;
  status.state = haply::stateOf(device);
  const Message message = haply::describe(status);
  const DeviceInfo limits = haply::limitsOf(device.type.view());
  const std::string id = haply::idOf(device.id.view()), state(haply::nameOf(status.state));
  json["haplys"].push_back({{"id", id},
                            {"name", haply::nameOf(device.type.view(), device.id.view())},
                            {"type", std::string(device.type.view())},
                            {"state", state},
                            {"code", codeOf(message)},
                            {"max_force_n", limits.max_force_n},
                            {"max_stiffness_n_per_mm", limits.max_stiffness_n_per_mm}});
  outcome.lines.push_back(id + ": " + haply::nameOf(device.type.view(), device.id.view()) + ", " +
                          state);
  if (status.state == haply::LinkState::ready) return;
  outcome.exit_code = kDeviceExit;
  tellMessage(message);
}
}  // namespace

void listHaplys(Json& json, CommandResult& outcome) {
  json["haplys"] = Json::array();
  json["haply_service"] = nullptr;
  const haply::ServiceAddress address = haply::serviceAddress();
  // Without it there is nothing to say: most have no such device.
  if (!haply::hasInverseService() || !haply::isListenedTo(address)) return;
  const std::unique_ptr<haply::Service> service = haply::inverseService(address);
  const haply::Inventory inventory = haply::lookAround(*service, {});
  haply::LinkStatus status = haply::choose(inventory, *service, {}).status;
  const bool is_service = inventory.state == haply::LinkState::ready;
  const bool sees_none = is_service && inventory.seen.told().empty();
  const Message message = haply::describe(status);
  json["haply_service"] = {
      {"address", service->address()},
      {"version", std::string(inventory.version.text.view())},
      {"state", is_service && !sees_none ? "ready" : std::string(haply::nameOf(status.state))},
      {"code", is_service && !sees_none ? "" : codeOf(message)}};
  outcome.lines.push_back("Haply's Inverse Service at " + service->address() +
                          (is_service ? ", version " + std::string(inventory.version.text.view())
                                      : ": cannot be used"));
  // Others may listen at its port; that one has no device plugged in is no fault.
  if (!is_service || sees_none) tellMessage(message);
  for (const haply::ServiceDevice& device : inventory.seen.told()) listOne(device, json, outcome);
}

}  // namespace relievo::batch
