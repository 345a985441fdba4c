// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/device/haply/events.h"

#include <algorithm>
#include <utility>

#include "core/message/catalogue.h"

namespace relievo::haply {

namespace {
struct Known {
  std::string_view name, safety;  // Its name; of a safety event, of which type.
  EventKind kind;
};
constexpr std::array<Known, kEventKinds> kKnown{
    {{"device-connected", "", EventKind::connected},
     {"device-disconnected", "", EventKind::disconnected},
     {"device-connection-loop", "", EventKind::connection_loop},
     {"device-battery-low", "", EventKind::battery_low},
     {"device-sleep", "", EventKind::sleep},
     {"device-calibration-failed", "", EventKind::calibration_failed},
     {"device-safety-triggered", "ebrake_triggered", EventKind::brake_pressed},
     {"device-safety-triggered", "ebrake_released", EventKind::brake_released},
     {"device-safety-triggered", "stall_detected", EventKind::stalled},
     {"device-safety-triggered", "stability_ceiling", EventKind::unstable}}};

/// What is longer than any that is known is none of them.
void readWord(JsonReader& json, ShortText& into) {
  std::string_view text;
  if (json.string(text) && !into.take(text)) into = {};
}
}  // namespace

std::optional<ServiceEvent> readEvent(std::string_view text) noexcept {
  ShortText name, safety;
  ServiceEvent event;
  JsonReader json(text);
  json.object([&](std::string_view key) {
    if (key == "name") readWord(json, name);
    if (key != "data") return;
    json.object([&](std::string_view part) {
      if (part == "safety_type") readWord(json, safety);
      if (part == "device_id") readWord(json, event.device);
    });
  });
  if (!json.atEnd()) return std::nullopt;
  const auto found = std::find_if(kKnown.begin(), kKnown.end(), [&](const Known& known) {
    return known.name == name.view() && (known.safety.empty() || known.safety == safety.view());
  });
  if (found == kKnown.end()) return std::nullopt;
  event.kind = found->kind;
  return event;
}

Message describe(const ServiceEvent& event) {
  switch (event.kind) {
    case EventKind::connected:
      return said<MessageId::haply_event_connected>();
    case EventKind::disconnected:
      return said<MessageId::haply_event_disconnected>();
    case EventKind::connection_loop:
      return said<MessageId::haply_event_connection_loop>();
    case EventKind::battery_low:
      return said<MessageId::haply_event_battery_low>();
    case EventKind::sleep:
      return said<MessageId::haply_event_sleep>();
    case EventKind::calibration_failed:
      return said<MessageId::haply_event_calibration_failed>();
    case EventKind::brake_pressed:
      return said<MessageId::haply_event_brake_pressed>();
    case EventKind::brake_released:
      return said<MessageId::haply_event_brake_released>();
    case EventKind::stalled:
      return said<MessageId::haply_event_stalled>();
    case EventKind::unstable:
      break;
  }
  return said<MessageId::haply_event_unstable>();
}

bool EventNews::isNews(const ServiceEvent& event, std::int64_t now_ns) noexcept {
  constexpr std::int64_t kQuietNs = 10'000'000'000;
  std::int64_t& told_ns = told_ns_[static_cast<std::size_t>(event.kind)];
  if (told_ns != 0 && now_ns - told_ns < kQuietNs) return false;
  told_ns = now_ns;
  return true;
}

}  // namespace relievo::haply
