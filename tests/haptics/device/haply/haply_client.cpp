// SPDX-License-Identifier: BSD-3-Clause
// A program that orders 3 N of a device of Haply until it is killed:
//   haply_client PORT
#include <cstdlib>
#include <string>

#include "haptics/device/haply/haply_device.h"
#include "haptics/device/haply/service_address.h"
#include "haptics/rt/realtime_thread.h"

int main(int count, char** words) {
  auto address = relievo::haply::addressOf(count == 2 ? words[1] : "");
  if (!address) return 2;
  address->patience_ns = 60'000'000'000;
  relievo::haply::HaplyDevice device(relievo::haply::inverseService(*address), {});
  device.open();
  for (std::int64_t next_ns = relievo::monotonicNs();; next_ns += 1'000'000) {
    const std::int64_t now_ns = relievo::monotonicNs();
    device.read(now_ns);
    device.send({0, 0, 3}, now_ns);
    relievo::sleepUntil(next_ns);
  }
}
