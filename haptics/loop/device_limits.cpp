// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/loop/device_limits.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace relievo {

namespace {
/// A limit of 0 is none.
void keepBelow(double& value, double limit) RELIEVO_REALTIME {
  if (limit > 0) value = std::min(value, limit);
}

std::string numberText(double value) {
  std::array<char, 40> text{};
  const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() ? std::string(text.data(), end) : std::string("?");
}

/// Adds "WHAT NOW UNIT instead of ASKED".
void add(std::string& to, const char* what, double asked, double now, const char* unit) {
  if (now == asked) return;
  to.append(to.empty() ? "" : ", ").append(what).append(" ").append(numberText(now));
  to.append(unit).append(" instead of ").append(numberText(asked));
}
}  // namespace

HapticOptions withinDevice(HapticOptions options, const DeviceInfo& device) RELIEVO_REALTIME {
  ForceOptions& force = options.force;
  keepBelow(force.limit_n, device.max_force_n);
  keepBelow(force.stiffness_n_per_mm, device.max_stiffness_n_per_mm);
  for (double& k : options.detail_stiffness) keepBelow(k, device.max_stiffness_n_per_mm);
  // What nobody has set is what this device holds.
  const DetailStiffness held = detailStiffness(timingOf(device));
  for (std::size_t i = 0; i < held.size(); ++i) {
    double& k = options.detail_stiffness[i];
    if (device.max_force_n > 0 && k == kDetailStiffness[i]) k = held[i];
  }
  const bool lifts = options.holds_grip && !device.holds_its_grip;
  force.lift_n = lifts ? std::max(0.0, device.grip_weight_n) : 0;
  options.timing = timingOf(device);
  if (!(device.max_force_n > 0)) options.timing.rate_hz = 0;
  keepBelow(force.damping_n_s_per_mm, device.max_damping_n_s_per_mm);
  keepBelow(force.engage_slew_n_per_s, device.max_slew_n_per_s);
  keepBelow(force.contact_slew_n_per_s, device.max_slew_n_per_s);
  // Mouse and keys say where the hand is on the relief, and so does whoever simulates one.
  if (device.simulated || !(device.max_force_n > 0)) options.grip = GripPosition::upright;
  force.lift_out = options.grip == GripPosition::flat;
  options.workspace = handFromDevice(options.grip, device.workspace);
  options.cushion = options.cushion || (!device.simulated && device.max_force_n > 0);
  force.passivity.position_step_mm = device.position_step_mm;
  force.passivity.force_delay_ticks = device.force_delay_ticks;
  return options;
}

std::string limitedText(const HapticOptions& asked, const DeviceInfo& device) {
  const HapticOptions now = withinDevice(asked, device);
  const ForceOptions &before = asked.force, &after = now.force;
  std::string parts;
  if (asked.stiffness_by_detail) {
    const double most =
        *std::max_element(asked.detail_stiffness.begin(), asked.detail_stiffness.end());
    const double left = *std::max_element(now.detail_stiffness.begin(), now.detail_stiffness.end());
    add(parts, "stiffness", most, left, " N/mm");
  } else {
    add(parts, "stiffness", before.stiffness_n_per_mm, after.stiffness_n_per_mm, " N/mm");
  }
  add(parts, "damping", before.damping_n_s_per_mm, after.damping_n_s_per_mm, " N s/mm");
  add(parts, "force", before.limit_n, after.limit_n, " N");
  add(parts, "change of force", before.contact_slew_n_per_s, after.contact_slew_n_per_s, " N/s");
  if (parts.empty()) return {};
  return "More was asked for than the device (" + device.name + ") is made for: " + parts + ".";
}

}  // namespace relievo
