// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>

#include "core/base/vec3.h"
#include "core/message/message.h"
#include "haptics/device/haply/messages.h"

namespace relievo::haply {

/// What keeps a device from being felt; the state after each is the next one that applies.
enum class LinkState : std::uint8_t {
  closed,
  no_service,      ///< Nobody listens (E311).
  other_service,   ///< Somebody else does, or tells no version (E312).
  old_service,     ///< E312
  no_device,       ///< The service sees none, or not the chosen one (E313).
  several,         ///< More than one could be meant.
  checking,        ///< It is being set up, and asked whether that was done.
  no_power,        ///< E315
  not_started,     ///< E315
  not_calibrated,  ///< E314
  foreign,         ///< Others set it up again and again, or it does not tell (E316).
  disobeyed,       ///< Forces are sent and none is told (E317).
  pushed,          ///< More force is told than was sent (E318).
  ready,
  silent,  ///< It stopped answering.
};

struct LinkCounts {
  std::uint64_t answers = 0;
  std::uint64_t extra = 0;           ///< Answers to nothing that was asked.
  std::uint64_t nonsense = 0;        ///< Messages that were not believed.
  std::uint64_t hiccups = 0;         ///< No answer for 5 ms: zero force sent.
  std::uint64_t stalls = 0;          ///< None for 20 ms: forces off.
  std::uint64_t jumps = 0;           ///< The place jumped: forces off until the set-up was checked.
  std::uint64_t configurations = 0;  ///< How often it was set up.
  std::uint64_t lost = 0;            ///< Sessions that ended by themselves.
  std::int64_t worst_answer_ns = 0;
};

/// What `relievo devices` and the status bar show.
struct LinkStatus {
  LinkState state = LinkState::closed;
  bool was_open = false;             ///< It was there before: what is said differs.
  ShortText id, type;                ///< Of the device; empty: none is known.
  ShortText version;                 ///< Of the service.
  std::array<char, 64> address{};    ///< Zero-terminated, as the next ones.
  std::array<char, 64> detail{};     ///< What answered instead.
  std::array<char, 200> others{};    ///< Those that are there, "049D, 04BA"; none of them is taken.
  std::array<char, 40> wanted{};     ///< "Haply 049D"; empty: any.
  double ordered_n = 0, told_n = 0;  ///< When the service disobeyed.
  double rate_hz = 0;                ///< Answers per second, over the last quarter second or so.
  DeviceMm position;
  std::uint32_t buttons = 0;
  LinkCounts counts;
};
static_assert(std::is_trivially_copyable_v<LinkStatus>);

template <std::size_t Size>
void put(std::string_view text, std::array<char, Size>& into) noexcept {
  into.fill('\0');
  text.copy(into.data(), Size - 1);
}

/// What happened, and what you can do.
Message describe(const LinkStatus& status);
/// "not_calibrated", for reports.
std::string_view nameOf(LinkState state) noexcept;
/// For people, in every language: "Haply Inverse3 049D".
std::string nameOf(std::string_view type, std::string_view id);

}  // namespace relievo::haply
