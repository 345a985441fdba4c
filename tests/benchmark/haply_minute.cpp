// SPDX-License-Identifier: BSD-3-Clause
// How a device of Haply's runs for a while on the mock of its service, with a hand that presses on
// a plane: answers and messages, how long the loop's exchange takes, whether the contact is steady.
//   haply_minute [SECONDS]
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <new>
#include <string>
#include <vector>

#include "haptics/device/haply/haply_device.h"
#include "haptics/device/haply/service_address.h"
#include "haptics/rt/realtime_thread.h"
#include "tests/emulator/haply/inverse_service.h"

namespace {
thread_local long long allocations = 0;
}

void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t /*size*/) noexcept {
  std::free(memory);
}

namespace {
using relievo::haply::LinkState;

double part(std::vector<double>& values, double of_one) {
  const auto place = static_cast<std::ptrdiff_t>(of_one * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + place, values.end());
  return values[static_cast<std::size_t>(place)];
}
}  // namespace

int main(int count, char** words) {
  const int seconds = count > 1 ? std::atoi(words[1]) : 60;
  if (seconds < 2) return 2;
  relievo::emulator::InverseService mock;
  auto address = relievo::haply::addressOf(std::to_string(mock.port()));
  address->patience_ns = 60'000'000'000;
  relievo::haply::HaplyDevice device(relievo::haply::inverseService(*address), {});
  device.open();
  while (device.status().state != LinkState::ready) {
    const std::int64_t now_ns = relievo::monotonicNs();
    device.read(now_ns);
    device.send({}, now_ns);
    relievo::sleepUntil(now_ns + 1'000'000);
  }
  mock.with([](relievo::emulator::HaplyWorld& world) { world.pullToward({0, 0, -4}); });
  const auto messages_before = mock.with([](const auto& world) { return world.messages; });
  const auto answers_before = device.status().counts.answers;
  constexpr int kPriority = 80;  // The loop's.
  const relievo::RealtimeGrant grant = relievo::requestRealtime(kPriority, {});
  const std::int64_t begin_ns = relievo::monotonicNs();
  const long ticks = 1000L * seconds;
  std::vector<double> exchange_us(static_cast<std::size_t>(ticks));
  long touching = 0, faults = 0, well = 0, rested = 0;
  double low_mm = 0, high_mm = -1e9;
  relievo::DeviceN force;
  const long long allocations_before = allocations;
  for (long tick = 0; tick < ticks; ++tick) {
    const std::int64_t now_ns = relievo::monotonicNs();
    const relievo::DeviceReading reading = device.read(now_ns);
    device.send(force, now_ns);
    exchange_us[static_cast<std::size_t>(tick)] =
        1e-3 * static_cast<double>(relievo::monotonicNs() - now_ns);
    constexpr double kStiffness = 0.4;  // N/mm.
    force.z = kStiffness * std::max(0.0, -reading.position.z);
    touching += force.z > 0 ? 1 : 0;
    faults += reading.fault != relievo::DeviceFault::none ? 1 : 0;
    well = reading.fault == relievo::DeviceFault::none ? well + 1 : 0;
    if (well > 1000) {
      ++rested;
      low_mm = std::min(low_mm, reading.position.z);
      high_mm = std::max(high_mm, reading.position.z);
    }
    relievo::sleepUntil(begin_ns + (tick + 1) * 1'000'000);
  }
  const long long allocated = allocations - allocations_before;
  const auto& status = device.status();
  const auto messages = mock.with([](const auto& world) { return world.messages; });
  const double took_s = 1e-9 * static_cast<double>(relievo::monotonicNs() - begin_ns);
  std::printf("%.1f s, %ld ticks, real-time priority %s\n", took_s, ticks,
              grant.realtime ? "granted" : "refused");
  std::printf("messages %llu, answers %llu, extra %llu, nonsense %llu, hiccups %llu, stalls %llu\n",
              static_cast<unsigned long long>(messages - messages_before),
              static_cast<unsigned long long>(status.counts.answers - answers_before),
              static_cast<unsigned long long>(status.counts.extra),
              static_cast<unsigned long long>(status.counts.nonsense),
              static_cast<unsigned long long>(status.counts.hiccups),
              static_cast<unsigned long long>(status.counts.stalls));
  std::printf("exchange: p50 %.2f us, p99 %.2f us, largest %.1f us; %lld allocations\n",
              part(exchange_us, 0.5), part(exchange_us, 0.99), part(exchange_us, 1), allocated);
  const auto per_cent = [&](long some) {
    return 100.0 * static_cast<double>(some) / static_cast<double>(ticks);
  };
  std::printf(
      "touching in %.1f %% of the ticks, faults in %.2f %%; the hand between %.3f and %.3f "
      "mm in the %.1f %% that had no fault for a second\n",
      per_cent(touching), per_cent(faults), low_mm, high_mm, per_cent(rested));
  return 0;
}
