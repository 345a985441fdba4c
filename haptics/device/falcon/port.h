// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "core/message/message.h"
#include "haptics/device/falcon/choice.h"
#include "haptics/device/falcon/protocol.h"

namespace relievo::falcon {

enum class PortResult : std::uint8_t {
  ok,
  timeout,  ///< The device takes nothing.
  gone,     ///< Unplugged.
  failed,   ///< The transfer broke off, though the device is still there.
};

/// Errors that the bridge chip has reported since the port was opened.
struct LineErrors {
  std::uint64_t overruns = 0, framing = 0, parity = 0;  ///< A break counts as framing.
  void add(const LineStatus& status) {
    overruns += status.overrun ? 1 : 0;
    framing += status.framing || status.broken ? 1 : 0;
    parity += status.parity ? 1 : 0;
  }
};

/// One open Falcon: the only place where the driver waits. All calls: one thread.
class Port {
 public:
  Port() = default;
  virtual ~Port() = default;
  Port(const Port&) = delete;
  Port& operator=(const Port&) = delete;

  /// A request to the bridge chip; waits for its end, a second at most.
  virtual PortResult request(const BridgeRequest& request) = 0;
  /// Hands over at most 62 bytes; waits for the bytes before, 100 ms at most.
  virtual PortResult write(std::span<const std::uint8_t> bytes) = 0;

  struct Incoming {
    std::size_t bytes = 0;
    PortResult result = PortResult::ok;
    bool damaged = false;  ///< Bytes before these were thrown away: begin anew with them.
  };
  /// What has come, line status taken out; waits for the first byte until `until_ns`. A failure is
  /// told at once, before what came after it; the next read takes up reading again, after 5 ms.
  virtual Incoming read(std::span<std::uint8_t> into, std::int64_t until_ns) = 0;
  /// Forgets what has come and was not read.
  virtual void discardInput() = 0;
  virtual bool clearToSend() const = 0;
  virtual LineErrors lineErrors() const = 0;
};

enum class Presence : std::uint8_t {
  present,
  absent,
  forbidden,  ///< The system does not let this account use it (E301).
  busy,       ///< Another program uses it (E304).
  broken,     ///< Something else; `Opening::detail` says what.
  several,    ///< More than one could be meant; none is taken.
};

struct Opening {
  Presence presence = Presence::absent;
  std::unique_ptr<Port> port;     ///< Set if present.
  std::optional<Message> detail;  ///< If broken.
  SeenFalcon which{};             ///< That was opened, if present.
  std::string wanted{};  ///< The one that is meant, as nameOf() has it, if one is; if absent.
  std::string others{};  ///< Those that are there, if none of them is taken.
};

/// Where Falcons are plugged in, and the clock of their port.
class Bus {
 public:
  Bus() = default;
  virtual ~Bus() = default;
  Bus(const Bus&) = delete;
  Bus& operator=(const Bus&) = delete;

  virtual Opening open() = 0;
  /// The one that is meant. A bus with one place has no choice.
  virtual FalconChoice choice() const { return {}; }
  /// Waits until something may have changed, or until `until_ns`.
  virtual void waitForChange(std::int64_t until_ns) = 0;
  virtual std::int64_t now() = 0;  ///< Monotonic, ns.
  /// Time the computer has slept in all, ns. A change means that everything known is old.
  virtual std::int64_t slept() { return 0; }
};

}  // namespace relievo::falcon
