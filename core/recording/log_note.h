// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace relievo {

/// What a person notes while the loop is at a tick: "note at tick N: TEXT", with any characters but
/// line ends.
std::string noteEvent(std::uint64_t tick, std::string_view text);

/// A note that stands at the beginning of an event or of a log's line, and its tick.
struct Note {
  std::uint64_t tick = 0;
  std::string text;
};
std::optional<Note> noteIn(std::string_view event);

}  // namespace relievo
