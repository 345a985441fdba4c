// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "core/message/message.h"
#include "haptics/device/haply/scanner.h"

namespace relievo::haply {

/// What the service tells on its channel of events. For people to read: what it means for forces
/// stands in every state.
enum class EventKind : std::uint8_t {
  connected,
  disconnected,
  connection_loop,  ///< It connects and disconnects again and again.
  battery_low,
  sleep,
  calibration_failed,
  brake_pressed,
  brake_released,
  stalled,   ///< A motor is held fast.
  unstable,  ///< Forces are held below a ceiling.
};
inline constexpr std::size_t kEventKinds = 10;

struct ServiceEvent {
  EventKind kind = EventKind::connected;
  ShortText device;  ///< Its id; empty: not told.
};
/// Without allocation. Nothing: damaged, or of a name that is not known.
std::optional<ServiceEvent> readEvent(std::string_view text) noexcept;
/// For people: what happened, and what to do.
Message describe(const ServiceEvent& event);

/// Which events are news: one that repeats is told once in ten seconds. No clock of its own.
class EventNews {
 public:
  bool isNews(const ServiceEvent& event, std::int64_t now_ns) noexcept;

 private:
  std::array<std::int64_t, kEventKinds> told_ns_{};  // 0: never.
};

}  // namespace relievo::haply
