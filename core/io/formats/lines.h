// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>
#include <string_view>

namespace relievo {

/// Lines of a text in memory, ended by LF, CR LF or CR; counts them for messages.
class Lines {
 public:
  explicit Lines(std::string_view text, std::uint64_t lines_before = 0)
      : rest_(text), number_(lines_before) {}

  /// Moves to the next line. @return  false at the end
  bool next() noexcept {
    if (rest_.empty()) return false;
    ++number_;
    findLineFeed();
    auto end = static_cast<std::size_t>(line_feed_ - rest_.data());
    ended_ = end < rest_.size();
    const auto* cr = static_cast<const char*>(std::memchr(rest_.data(), '\r', end));
    std::size_t skip = ended_ ? 1 : 0;
    if (cr != nullptr) {
      const auto at = static_cast<std::size_t>(cr - rest_.data());
      skip = at + 1 == end && ended_ ? 2 : 1;
      end = at;
      ended_ = true;
    }
    line_ = rest_.substr(0, end);
    rest_.remove_prefix(end + skip);
    return true;
  }

  std::string_view line() const noexcept { return line_; }
  std::string_view rest() const noexcept { return rest_; }
  std::uint64_t number() const noexcept { return number_; }  ///< Of the current line, from 1.
  bool ended() const noexcept { return ended_; }             ///< By a line end, not by the file.

 private:
  /// Keeps the next LF, so that a file of CR lines is not searched to its end for every line.
  void findLineFeed() noexcept {
    if (line_feed_ != nullptr && line_feed_ >= rest_.data()) return;
    const void* const lf = std::memchr(rest_.data(), '\n', rest_.size());
    line_feed_ = lf != nullptr ? static_cast<const char*>(lf) : rest_.data() + rest_.size();
  }

  std::string_view rest_, line_;
  const char* line_feed_ = nullptr;  ///< The next one in rest_, or its end.
  std::uint64_t number_;
  bool ended_ = false;
};

inline bool isBlank(char c) noexcept {
  return c == ' ' || c == '\t' || c == '\f' || c == '\v' || c == '\r';
}

inline std::string_view trimmed(std::string_view text) noexcept {
  while (!text.empty() && isBlank(text.front())) text.remove_prefix(1);
  while (!text.empty() && isBlank(text.back())) text.remove_suffix(1);
  return text;
}

/// Takes the next word off the front of `rest`; empty at the end.
inline std::string_view takeWord(std::string_view& rest) noexcept {
  std::size_t start = 0;
  while (start < rest.size() && isBlank(rest[start])) ++start;
  std::size_t end = start;
  while (end < rest.size() && !isBlank(rest[end])) ++end;
  const std::string_view word = rest.substr(start, end - start);
  rest.remove_prefix(end);
  return word;
}

inline std::string_view firstWord(std::string_view line) noexcept {
  return takeWord(line);
}

/// A CR that no LF follows: the line end of old Macs.
inline bool hasLoneCr(std::string_view text) noexcept {
  for (std::size_t at = text.find('\r'); at != std::string_view::npos;
       at = text.find('\r', at + 1)) {
    if (at + 1 == text.size() || text[at + 1] != '\n') return true;
  }
  return false;
}

/// The whole of `word` as a number; nan and inf are numbers, 1e999 is infinite, 1e-999 is 0.
/// Independent of the locale.
inline std::optional<double> parseNumber(std::string_view word) noexcept {
  if (word.size() > 1 && word.front() == '+' && word[1] != '-') word.remove_prefix(1);
  double value = 0;
  const char* const end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  if (stop != end || error == std::errc::invalid_argument) return std::nullopt;
  if (error == std::errc::result_out_of_range) {
    const bool tiny =
        word.find("e-") != std::string_view::npos || word.find("E-") != std::string_view::npos;
    return tiny ? 0.0 : std::numeric_limits<double>::infinity();
  }
  return value;
}

/// The whole of `word` as a whole number.
template <class Whole>
std::optional<Whole> parseWhole(std::string_view word) noexcept {
  Whole value = 0;
  const char* const end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  if (stop != end || error != std::errc{}) return std::nullopt;
  return value;
}

}  // namespace relievo
