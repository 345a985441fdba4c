// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <stop_token>
#include <string>
#include <string_view>

#include "haptics/device/haply/messages.h"

namespace relievo::haply {

enum class PortResult : std::uint8_t {
  ok,
  timeout,  ///< Nothing in time.
  gone,     ///< Closed, or unusable from now on.
};

/// One open session with the service: the only place where the driver waits. All calls: one thread.
/// A session that is left closes.
class Port {
 public:
  Port() = default;
  virtual ~Port() = default;
  Port(const Port&) = delete;
  Port& operator=(const Port&) = delete;

  /// One message. One that was not handed over in time makes the session useless.
  virtual PortResult send(std::string_view text, std::int64_t until_ns) = 0;

  struct Incoming {
    PortResult result = PortResult::timeout;
    std::string_view text;  ///< Valid until the next receive().
  };
  /// The next message, in the order in which they came. What is late is kept for the next call.
  virtual Incoming receive(std::int64_t until_ns) = 0;
};

enum class Reached : std::uint8_t {
  connected,
  absent,   ///< Nobody listens there.
  other,    ///< Somebody else, or a service that does not tell its version; `detail`.
  too_old,  ///< Or too new; `version`.
};

struct Connection {
  Reached reached = Reached::absent;
  std::unique_ptr<Port> port{};  ///< Set if connected.
  ServiceVersion version{};
  std::string detail{};
};

inline constexpr std::int64_t kPatienceNs = 1'000'000'000;

/// Haply's Inverse Service, wherever it listens, and the clock of its sessions. All calls but
/// address(): one thread.
class Service {
 public:
  Service() = default;
  virtual ~Service() = default;
  Service(const Service&) = delete;
  Service& operator=(const Service&) = delete;

  virtual std::string address() const = 0;  ///< For people: "127.0.0.1:10001".
  /// Asks for the version and begins a session; waits at most patienceNs() at each port, and at
  /// most 100 ms after a stop. @throw DeviceError  this build cannot
  virtual Connection connect(const std::stop_token& stop) = 0;
  virtual std::int64_t patienceNs() const { return kPatienceNs; }
  virtual std::int64_t now() const = 0;
  virtual void sleepUntil(std::int64_t time_ns) = 0;
};

}  // namespace relievo::haply
