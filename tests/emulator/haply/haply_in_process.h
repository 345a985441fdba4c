// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <string>

#include "haptics/device/haply/port.h"
#include "tests/emulator/haply/haply_world.h"

namespace relievo::emulator {

/// The mock service in this process, on a made-up clock: nothing waits, and nothing is late that
/// was not told to be.
class HaplyInProcess : public haply::Service {
 public:
  HaplyWorld world;
  bool runs = true;      ///< Somebody listens.
  bool foreign = false;  ///< Somebody else does, without a version.
  int connections = 0;
  /// Called with every millisecond of the clock; what it throws ends the link.
  std::function<void(std::int64_t now_ns)> each_ms = {};

  /// The computer sleeps: time goes on, and nobody sees it. From each_ms.
  void sleepThrough(std::int64_t ns) { now_ns_ += ns; }

  std::string address() const override { return "127.0.0.1:10001"; }
  haply::Connection connect(const std::stop_token& stop) override;
  std::int64_t now() const override { return now_ns_; }
  void sleepUntil(std::int64_t time_ns) override;

 private:
  friend class HaplySession;
  std::int64_t now_ns_ = 1'000'000'000;
};

}  // namespace relievo::emulator
