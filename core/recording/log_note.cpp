// SPDX-License-Identifier: BSD-3-Clause
#include "core/recording/log_note.h"

#include <algorithm>
#include <charconv>
#include <system_error>

namespace relievo {

namespace {
constexpr std::string_view kNoteWords = "note at tick ";
}

std::string noteEvent(std::uint64_t tick, std::string_view text) {
  std::string event = std::string(kNoteWords) + std::to_string(tick) + ": " + std::string(text);
  std::replace_if(
      event.begin(), event.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return event;
}

std::optional<Note> noteIn(std::string_view event) {
  if (!event.starts_with(kNoteWords)) return std::nullopt;
  event.remove_prefix(kNoteWords.size());
  Note note;
  const auto [end, error] = std::from_chars(event.data(), event.data() + event.size(), note.tick);
  event.remove_prefix(static_cast<std::size_t>(end - event.data()));
  if (error != std::errc() || !event.starts_with(": ")) return std::nullopt;
  note.text = event.substr(2, event.find_last_not_of(' ') - 1);  // A log's room ends in blanks.
  return note;
}

}  // namespace relievo
