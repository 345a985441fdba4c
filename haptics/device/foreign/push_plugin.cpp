// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/device/foreign/push_plugin.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

#include "core/base/error.h"
#include "core/base/failure.h"
#include "haptics/rt/realtime_thread.h"

namespace relievo::foreign {

namespace {
constexpr std::int64_t kMs = 1'000'000;
/// No hand is surprised by it.
constexpr double kMostNPerS = 10;
constexpr std::int64_t kReadyNs = 60'000 * kMs;

/// Up, and down again. @param part  of the time, 0 .. 1
double triangle(double part) {
  return std::max(0.0, 1 - std::abs(2 * part - 1));
}

/// A device may be silent for a moment, as on a busy computer: then the force is off, and rises anew
/// from zero. Any other fault ends it. It goes by orders and not by the clock: of a computer that
/// is busy there are as many, later.
/// @return why it ended before its time; empty: it did not
std::string push(ForeignDevice& device, double most_n, double seconds, const Task& task) {
  constexpr double kOrdersPerS = 1000;
  const double orders = kOrdersPerS * std::max(seconds, 2 * most_n / kMostNPerS);
  const std::int64_t give_up_ns = monotonicNs() + kReadyNs;
  bool began = false;
  for (double order = 0; order < orders;) {
    task.check();
    const std::int64_t now_ns = monotonicNs();
    const DeviceFault fault = device.read(now_ns).fault;
    if (fault == DeviceFault::none) {
      began = true;
      device.send({most_n * triangle(order++ / orders), 0, 0}, now_ns);
    } else {
      device.send({}, now_ns);
      order = 0;
      const bool waits =
          fault == DeviceFault::timeout || (fault == DeviceFault::not_ready && !began);
      if (!waits || device.isLost()) {
        return "while the force rose or fell: " + std::string(describe(fault));
      }
    }
    if (order == 0 && now_ns > give_up_ns) return "it is not ready for a whole minute";
    sleepUntil(now_ns + kMs);
  }
  return {};
}
}  // namespace

CheckResult pushPlugin(const Check& check, const std::filesystem::path& file,
                       const Conformance& how, const Task& task) {
  if (how.newton <= 0) {
    return {check, Verdict::skipped, "it takes a hand at the grip; ask for it by --newton"};
  }
  if (!how.is_held || !how.is_held()) {
    return {check, Verdict::skipped, "nobody said that a hand holds the grip"};
  }
  ForeignDevice device(file, how.device, "plugin:tested/" + how.device, how.device, how.patience);
  try {
    device.open();
  } catch (const DeviceError& error) {
    return {check, Verdict::failed, englishText(messageOf(error))};
  }
  const double most_n = std::min(how.newton, device.info().max_force_n);
  const std::string why = push(device, most_n, how.seconds, task);
  device.close();  // At zero, whatever was ordered last.
  return {check, why.empty() ? Verdict::passed : Verdict::failed, why};
}

}  // namespace relievo::foreign
