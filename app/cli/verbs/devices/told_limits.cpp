// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/verbs/devices/told_limits.h"

#include <algorithm>

#include "app/cli/json.h"

namespace relievo::batch {

std::string toldLimits(const DeviceInfo& device) {
  const DeviceMm& reach = device.workspace.half_extent;
  return Json{{"id", device.id},
              {"name", device.name},
              {"half_extent_mm", {reach.x, reach.y, reach.z}},
              {"max_force_n", device.max_force_n},
              {"max_stiffness_n_per_mm", device.max_stiffness_n_per_mm},
              {"max_damping_n_s_per_mm", device.max_damping_n_s_per_mm},
              {"max_slew_n_per_s", device.max_slew_n_per_s},
              {"position_step_mm", device.position_step_mm},
              {"force_delay_ticks", device.force_delay_ticks},
              {"rate_hz", device.rate_hz}}
      .dump();
}

std::optional<DeviceInfo> fromToldLimits(std::string_view text) {
  const Json json = Json::parse(text, nullptr, false);
  DeviceInfo device;
  try {
    device.id = json.at("id").get<std::string>();
    device.name = json.at("name").get<std::string>();
    const Json& reach = json.at("half_extent_mm");
    device.workspace.half_extent = {reach.at(0).get<double>(), reach.at(1).get<double>(),
                                    reach.at(2).get<double>()};
    device.max_force_n = json.at("max_force_n").get<double>();
    device.max_stiffness_n_per_mm = json.at("max_stiffness_n_per_mm").get<double>();
    device.max_damping_n_s_per_mm = json.at("max_damping_n_s_per_mm").get<double>();
    device.max_slew_n_per_s = json.at("max_slew_n_per_s").get<double>();
    device.position_step_mm = json.at("position_step_mm").get<double>();
    constexpr int kMostTicks = 2;
    device.force_delay_ticks = std::clamp(json.at("force_delay_ticks").get<int>(), 0, kMostTicks);
    device.rate_hz = json.at("rate_hz").get<double>();
  } catch (const Json::exception&) {
    return std::nullopt;
  }
  return device;
}

}  // namespace relievo::batch
