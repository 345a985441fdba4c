// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "haptics/device/haply/port.h"

namespace relievo::haply {

/// Where the service is looked for, in this order.
struct ServiceAddress {
  std::string host = "127.0.0.1";  ///< Not "localhost", which may mean ::1 first.
  std::vector<std::uint16_t> ports{10001, 10000};
  std::uint16_t events_port = 10020;       ///< 0: its events are not listened to.
  std::int64_t patience_ns = kPatienceNs;  ///< Until an answer is not waited for any more.
};
/// "10002", "127.0.0.1:10002", "[::1]:10002"; nothing: it is none.
std::optional<ServiceAddress> addressOf(std::string_view text);
/// By RELIEVO_HAPLY_SERVICE, else the usual one; the port of its events by RELIEVO_HAPLY_EVENTS,
/// else the usual one, but for a service that has a port of its own; its patience by
/// RELIEVO_HAPLY_PATIENCE_S, which is for tests on a busy computer: whole seconds, and anything
/// else is the usual one. @throw ArgumentError  it is none
ServiceAddress serviceAddress();

/// Somebody on this computer listens at one of those ports; nothing is said to them. Another
/// computer is not asked, and is taken to. [any thread]
bool isListenedTo(const ServiceAddress& address);
/// As serviceAddress() has it, and this build can connect; where it has none, nobody does.
bool isServiceThere();
/// A session with its channel of events; null: nobody takes one there, or not in time. Waits for
/// its patience at most, and 100 ms after a stop. [worker]
std::unique_ptr<Port> eventPort(const ServiceAddress& address, const std::stop_token& stop);
/// By Boost; without it one that says so when it is to connect.
std::unique_ptr<Service> inverseService(ServiceAddress address);
bool hasInverseService();  ///< This build can connect.

}  // namespace relievo::haply
