// SPDX-License-Identifier: BSD-3-Clause
// A program that orders 3 N of a plug-in's device until it is killed:
//   foreign_client FILE ID
// It writes the host's process number as soon as the force is ordered.
#include <cstdio>

#include "haptics/device/foreign/foreign_device.h"
#include "haptics/rt/realtime_thread.h"

int main(int count, char** words) {
  if (count != 3) return 2;
  relievo::foreign::ForeignDevice device(words[1], words[2], "plugin:client/it", "Stand-in",
                                         {.silence_ms = 60'000});  // Of a busy computer.
  device.open();
  std::printf("%d\n", device.hostPid());
  std::fflush(stdout);
  for (std::int64_t next_ns = relievo::monotonicNs();; next_ns += 1'000'000) {
    const std::int64_t now_ns = relievo::monotonicNs();
    device.read(now_ns);
    device.send({0, 0, 3}, now_ns);
    relievo::sleepUntil(next_ns);
  }
}
