// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace relievo::haply {

/// A short text without allocation: a name that a service gives.
class ShortText {
 public:
  static constexpr std::size_t kMost = 31;
  ShortText() = default;
  /// What is longer is cut.
  explicit ShortText(std::string_view text) noexcept { take(text); }
  /// What is longer is cut, too. @return false: it was
  bool take(std::string_view text) noexcept;
  std::string_view view() const noexcept { return {chars_.data(), size_}; }
  const char* text() const noexcept { return chars_.data(); }  ///< Zero-terminated.
  bool empty() const noexcept { return size_ == 0; }
  friend bool operator==(const ShortText&, const ShortText&) = default;

 private:
  std::array<char, kMost + 1> chars_{};
  std::uint8_t size_ = 0;
};

/// Reads one JSON text (RFC 8259) from front to back, strictly and without allocation. A fault
/// latches: nothing is read after it, and good() tells. A member that is null counts as missing.
class JsonReader {
 public:
  explicit JsonReader(std::string_view text) noexcept : text_(text) {}

  /// Calls each(key) for every member, in their order; `each` reads the value by one of these calls
  /// or leaves it, and then it is skipped. A key with escapes in it is given as it is written.
  template <class Each>
  bool object(Each each) {
    if (!enter('{')) return false;
    for (bool first = true; goesOn('}', first); first = false) {
      std::string_view key;
      if (!string(key) || !take(':')) return fail();
      if (null()) continue;
      const std::size_t before = at_;
      each(key);
      if (good_ && at_ == before) skip();
    }
    return leave();
  }
  /// Calls each() for every value of the array.
  template <class Each>
  bool array(Each each) {
    if (!enter('[')) return false;
    for (bool first = true; goesOn(']', first); first = false) {
      space();
      const std::size_t before = at_;
      each();
      if (good_ && at_ == before) skip();
    }
    return leave();
  }
  bool number(double& into) noexcept;  ///< Finite.
  bool boolean(bool& into) noexcept;
  bool string(std::string_view& into) noexcept;  ///< As it is written, escapes and all.
  bool skip() noexcept;                          ///< Any value.
  bool null() noexcept;                          ///< Taken if it is next; no fault if not.
  /// Nothing but space is left.
  bool atEnd() noexcept;
  bool good() const noexcept { return good_; }
  /// What was read is well-formed and means nothing sensible. @return false
  bool fail() noexcept { return good_ = false; }

 private:
  void space() noexcept;
  bool take(char wanted) noexcept;
  bool word(std::string_view wanted) noexcept;
  bool enter(char bracket) noexcept;
  bool leave() noexcept;
  bool goesOn(char bracket, bool first) noexcept;
  std::string_view numberText() noexcept;
  bool digits() noexcept;
  bool escape() noexcept;

  /// Deeper is nonsense: the service's own messages have eight levels.
  static constexpr int kMostDepth = 24;

  std::string_view text_;
  std::size_t at_ = 0;
  int depth_ = 0;
  bool good_ = true;
};

}  // namespace relievo::haply
