// SPDX-License-Identifier: BSD-3-Clause
// What relievo and the host of a plug-in for devices tell each other, under libFuzzer: the one may
// write anything into the page, or into the pipe, and the other must not break, must not push more
// than is allowed, and must not be anywhere that the device cannot be.
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstring>
#include <memory>

#include "haptics/device/foreign/host/device_round.h"
#include "haptics/device/foreign/host_answers.h"
#include "haptics/device/foreign/page_end.h"
#include "haptics/rt/realtime_thread.h"
#include "tests/fuzz/invariants.h"

namespace {

using namespace relievo;           // NOLINT(google-build-using-namespace): a program of one file.
using namespace relievo::foreign;  // NOLINT(google-build-using-namespace)

/// Values out of what libFuzzer gives; zeros when it is used up.
class Bytes {
 public:
  Bytes(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}

  bool empty() const { return size_ == 0; }
  void into(void* to, std::size_t bytes) {
    const std::size_t taken = std::min(bytes, size_);
    if (taken > 0) std::memcpy(to, data_, taken);
    data_ += taken;
    size_ -= taken;
  }
  template <class T>
  T take() {
    T value{};
    into(static_cast<void*>(&value), sizeof(value));
    return value;
  }
  std::string_view rest() const { return {reinterpret_cast<const char*>(data_), size_}; }

 private:
  const std::uint8_t* data_;
  std::size_t size_;
};

void requirePrintable(const std::string& text) {
  for (const char c : text) {
    fuzz::require(static_cast<unsigned char>(c) >= 32 && c != 127, "no command for a terminal");
  }
}

/// The pipe.
void readAnswer(const Bytes& bytes) {
  const ScannedPlugin plugin = pluginOf(bytes.rest());
  for (const std::string& text : {plugin.name, plugin.version, plugin.maker, plugin.licence}) {
    requirePrintable(text);
  }
  for (const SeenDevice& device : plugin.devices) {
    requirePrintable(device.name);
    fuzz::require(!device.id.empty() && device.id.find_first_of("/: ") == std::string::npos,
                  "an id is one word");
  }
  if (plugin.trouble) requirePrintable(englishText(*plugin.trouble));
  requirePrintable(resultOf(kChecks[0], bytes.rest()).why);
}

/// What a host that was led astray wrote.
void readPage(Bytes bytes) {
  constexpr DeviceMm kReach{40, 30, 20};
  constexpr std::int64_t kStaleNs = 20'000'000;
  auto page = std::make_unique<DevicePage>();
  PageEnd end(kReach, kStaleNs);
  while (!bytes.empty()) {
    bytes.into(static_cast<void*>(page.get()), sizeof(DevicePage));
    const auto now_ns = std::max<std::int64_t>(bytes.take<std::uint32_t>(), kStaleNs);
    const DeviceReading reading = end.read(*page, now_ns);
    fuzz::require(std::abs(reading.position.x) <= 2 * kReach.x &&
                      std::abs(reading.position.y) <= 2 * kReach.y &&
                      std::abs(reading.position.z) <= 2 * kReach.z,
                  "a place is near the device");
    fuzz::require(reading.fault <= DeviceFault::not_ready, "a fault is known");
    fuzz::require(reading.time_ns <= now_ns && reading.buttons < 16, "times and buttons are");
    fuzz::require(reading.fault != DeviceFault::none || reading.time_ns >= now_ns - kStaleNs,
                  "an old place is a fault");
    end.send(*page, {0, 0, 1}, now_ns);
    HostReport report;
    page->report.read(report);
    requirePrintable(textOf(report));
    requirePrintable(englishText(messageOf(report.trouble, report.number, textOf(report))));
    if (!arePossible(report.limits)) continue;
    DeviceInfo info;
    takeLimits(report.limits, info);
    fuzz::require(info.max_force_n >= 0 && info.max_force_n <= kMostForceN, "forces have a limit");
    fuzz::require(std::isfinite(info.max_stiffness_n_per_mm), "so has the stiffness");
    if (const auto heat = heatOf(*page, info.max_force_n)) {
      fuzz::require(heat->used >= 0 && heat->used <= 1 && heat->allowed_n <= info.max_force_n,
                    "heat is a part");
    }
  }
}

/// What a relievo that was led astray ordered, of a plug-in that says anything.
struct Played {
  Bytes bytes;
  std::array<double, 3> force_n{};
};
relievo_status step(void* self, const double* force_n, std::int64_t now_ns, relievo_sample* out) {
  auto& played = *static_cast<Played*>(self);
  std::copy_n(force_n, 3, played.force_n.begin());
  played.bytes.into(out, sizeof(*out));
  const auto status = played.bytes.take<std::int8_t>();
  if ((status & 1) != 0) out->time_ns = now_ns;  // Which no fuzzer would guess.
  return status >> 1;
}

void runRounds(Bytes bytes) {
  ForeignLimits limits = bytes.take<ForeignLimits>();
  if (!arePossible(limits)) limits = {.half_extent_mm = {40, 40, 40}, .max_force_n = 5};
  Played played{bytes};
  relievo_device device{};
  device.self = &played;
  device.step = step;
  auto page = std::make_unique<DevicePage>();
  std::atomic<std::int64_t> step_since_ns{0};
  DeviceRound round(device, *page, limits, step_since_ns);
  while (!played.bytes.empty() && !round.gone()) {
    auto order = played.bytes.take<ForceCommand>();
    const auto what = played.bytes.take<std::uint8_t>();
    const std::int64_t now_ns = monotonicNs();
    if ((what & 2) != 0) order.time_ns = now_ns;
    page->order.write(order);
    page->cuts = played.bytes.take<std::uint8_t>() & 1U;
    if ((what & 4) != 0) round.wasCut(now_ns);
    const bool zero = (what & 1) != 0;
    played.force_n = {};
    round.go(now_ns, zero);
    const double shown_n = std::hypot(played.force_n[0], played.force_n[1], played.force_n[2]);
    fuzz::require(shown_n <= rulesOf(limits).max_force_n + 1e-9, "forces have a limit");
    fuzz::require(!zero || shown_n == 0, "zero is zero");
    fuzz::require(step_since_ns == 0, "a step that came back is over");
    LinkReading reading;
    if (!page->reading.read(reading)) continue;
    for (const double place : {reading.position.x, reading.position.y, reading.position.z}) {
      fuzz::require(std::isfinite(place), "a place is a number");
    }
  }
}
}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Bytes bytes(data, size);
  switch (bytes.take<std::uint8_t>() % 3) {
    case 0:
      readAnswer(bytes);
      break;
    case 1:
      readPage(bytes);
      break;
    default:
      runRounds(bytes);
  }
  return 0;
}
