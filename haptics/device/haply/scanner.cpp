// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/device/haply/scanner.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>

namespace relievo::haply {

namespace {
bool isDigit(char c) noexcept {
  return c >= '0' && c <= '9';
}
bool isHexDigit(char c) noexcept {
  return isDigit(c) || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F');
}
}  // namespace

bool ShortText::take(std::string_view text) noexcept {
  const bool fits = text.size() <= kMost;
  text = text.substr(0, kMost);
  chars_.fill('\0');
  std::copy(text.begin(), text.end(), chars_.begin());
  size_ = static_cast<std::uint8_t>(text.size());
  return fits;
}

void JsonReader::space() noexcept {
  while (at_ < text_.size() &&
         (text_[at_] == ' ' || text_[at_] == '\t' || text_[at_] == '\n' || text_[at_] == '\r')) {
    ++at_;
  }
}

bool JsonReader::take(char wanted) noexcept {
  if (!good_) return false;
  space();
  if (at_ >= text_.size() || text_[at_] != wanted) return fail();
  ++at_;
  return true;
}

bool JsonReader::word(std::string_view wanted) noexcept {
  if (!good_) return false;
  space();
  if (!text_.substr(at_).starts_with(wanted)) return false;
  at_ += wanted.size();
  return true;
}

bool JsonReader::enter(char bracket) noexcept {
  return take(bracket) && (++depth_ <= kMostDepth || fail());
}

bool JsonReader::leave() noexcept {
  --depth_;
  return good_;
}

/// To the next member or value, or over the closing bracket.
bool JsonReader::goesOn(char bracket, bool first) noexcept {
  if (!good_) return false;
  space();
  if (at_ < text_.size() && text_[at_] == bracket) {
    ++at_;
    return false;
  }
  return first ? at_ < text_.size() || fail() : take(',');
}

bool JsonReader::digits() noexcept {
  const std::size_t before = at_;
  while (at_ < text_.size() && isDigit(text_[at_])) ++at_;
  return at_ > before;
}

/// Of JSON's form, which is stricter than the library's. Empty: it is none.
std::string_view JsonReader::numberText() noexcept {
  const std::size_t begin = at_;
  const auto next = [this](char c) { return at_ < text_.size() && text_[at_] == c; };
  if (next('-')) ++at_;
  if (next('0')) {
    ++at_;
  } else if (!digits()) {
    return {};
  }
  if (next('.')) {
    ++at_;
    if (!digits()) return {};
  }
  if (next('e') || next('E')) {
    ++at_;
    if (next('+') || next('-')) ++at_;
    if (!digits()) return {};
  }
  return text_.substr(begin, at_ - begin);
}

bool JsonReader::number(double& into) noexcept {
  if (!good_) return false;
  space();
  const std::string_view text = numberText();
  const char* const end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, into);
  if (text.empty() || read.ec != std::errc() || read.ptr != end || !std::isfinite(into)) {
    return fail();
  }
  return true;
}

bool JsonReader::boolean(bool& into) noexcept {
  into = word("true");
  return into || word("false") || fail();
}

bool JsonReader::null() noexcept {
  return word("null");
}

/// Behind a backslash.
bool JsonReader::escape() noexcept {
  if (at_ >= text_.size()) return false;
  const char c = text_[at_++];
  if (c != 'u') return std::string_view("\"\\/bfnrt").find(c) != std::string_view::npos;
  constexpr std::size_t kDigits = 4;
  for (std::size_t i = 0; i < kDigits; ++i) {
    if (at_ >= text_.size() || !isHexDigit(text_[at_])) return false;
    ++at_;
  }
  return true;
}

bool JsonReader::string(std::string_view& into) noexcept {
  if (!take('"')) return false;
  const std::size_t begin = at_;
  while (at_ < text_.size()) {
    const char c = text_[at_++];
    if (c == '"') {
      into = text_.substr(begin, at_ - 1 - begin);
      return true;
    }
    if (static_cast<unsigned char>(c) < 0x20) break;
    if (c == '\\' && !escape()) break;
  }
  return fail();
}

bool JsonReader::skip() noexcept {
  if (!good_) return false;
  space();
  if (at_ >= text_.size()) return fail();
  switch (text_[at_]) {
    case '{':
      return object([](std::string_view) {});
    case '[':
      return array([] {});
    case '"': {
      std::string_view ignored;
      return string(ignored);
    }
    default:
      return word("true") || word("false") || null() || !numberText().empty() || fail();
  }
}

bool JsonReader::atEnd() noexcept {
  space();
  return good_ && at_ == text_.size();
}

}  // namespace relievo::haply
