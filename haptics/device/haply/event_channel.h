// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <future>
#include <memory>
#include <stop_token>
#include <vector>

#include "haptics/device/haply/events.h"
#include "haptics/device/haply/port.h"
#include "haptics/device/haply/service_address.h"

namespace relievo::haply {

/// Listens to the service's events. Nothing is ever sent, and nothing of it reaches the link: a
/// channel that is silent, damaged or not there changes no force. All calls: one thread.
class EventChannel {
 public:
  /// @param address  without a port for events nobody is listened to
  explicit EventChannel(ServiceAddress address);
  ~EventChannel();  ///< Waits until a connection that was being made is given up: 100 ms at most.
  EventChannel(const EventChannel&) = delete;
  EventChannel& operator=(const EventChannel&) = delete;

  /// What came since the last call, the oldest first. Never waits: a connection is made beside it,
  /// and again every two seconds while there is none.
  std::vector<ServiceEvent> poll(std::int64_t now_ns);
  bool isConnected() const { return port_ != nullptr; }

 private:
  void connect(std::int64_t now_ns);

  ServiceAddress address_;
  std::stop_source stop_;
  std::future<std::unique_ptr<Port>> connecting_;
  std::unique_ptr<Port> port_;
  std::int64_t next_try_ns_ = 0;
};

}  // namespace relievo::haply
