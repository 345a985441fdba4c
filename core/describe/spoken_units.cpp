// SPDX-License-Identifier: BSD-3-Clause
#include "core/describe/spoken_units.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <vector>

#include "core/describe/sayable.h"
#include "core/message/catalogue.h"

namespace relievo {
namespace {

using Words = Message (*)(double value);

Message rounded(double value, Words words) {
  const SayableNumber number = sayableNumber(value);
  switch (number.nearness) {
    case SayableNumber::Nearness::nearly:
      return said<MessageId::sayable_nearly>(words(number.value));
    case SayableNumber::Nearness::over:
      return said<MessageId::sayable_over>(words(number.value));
    case SayableNumber::Nearness::exact:
      break;
  }
  return words(number.value);
}

bool isWhole(double value) {
  return std::abs(value - std::round(value)) < 1e-9;
}

NumberArgument number(double value) {
  return {.value = value, .digits = 4, .form = NumberArgument::Form::trimmed};
}

template <MessageId whole, MessageId part>
Message counted(double value) {
  if (isWhole(value)) return said<whole>(std::lround(value));
  return said<part>(number(value));
}

template <MessageId id>
Message measured(double value) {
  return said<id>(number(value));
}

/// What was written without a part is said as it is; the rest is rounded.
template <Words words>
Message sayable(double value) {
  return isWhole(value) ? words(value) : rounded(value, words);
}

template <int mm>
Message length(double value) {
  return sayableLength(mm * value);
}

struct Unit {
  std::string_view sign;
  Words words = nullptr;     ///< Of a number that is rounded as one says it.
  Words as_it_is = nullptr;  ///< Of one that keeps its digits and its unit.
};

template <Words words>
constexpr Unit unitOf(std::string_view sign) {
  return {sign, sayable<words>, words};
}

/// Longer signs before those that they begin with.
constexpr std::array<Unit, 11> kUnits{
    {unitOf<measured<MessageId::sayable_newton_per_mm>>("N/mm"),
     unitOf<counted<MessageId::sayable_newton, MessageId::sayable_part_newton>>("N"),
     unitOf<measured<MessageId::sayable_square_mm>>("mm²"),
     unitOf<measured<MessageId::sayable_cubic_mm>>("mm³"),
     {"mm", length<1>, counted<MessageId::sayable_mm, MessageId::sayable_part_mm>},
     {"cm", length<10>, counted<MessageId::sayable_cm, MessageId::sayable_part_cm>},
     {"m", length<1000>, counted<MessageId::sayable_m, MessageId::sayable_part_m>},
     unitOf<measured<MessageId::share_percent>>("%"),
     unitOf<counted<MessageId::sayable_degree, MessageId::sayable_part_degree>>("°"),
     unitOf<measured<MessageId::sayable_hertz>>("Hz"),
     unitOf<counted<MessageId::sayable_second, MessageId::sayable_part_second>>("s")}};

bool isDigit(char c) {
  return c >= '0' && c <= '9';
}

/// Of a word: letters of all scripts, whose bytes are beyond ASCII, as well.
bool isOfWord(char c) {
  return isDigit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' ||
         static_cast<unsigned char>(c) >= 0x80;
}

std::size_t blanksAt(std::string_view text) {
  for (const std::string_view blank : {" ", "\u00a0", "\u202f"}) {
    if (text.starts_with(blank)) return blank.size();
  }
  return 0;
}

/// Could a number begin here, or is it part of a word or of a number?
bool mayBeginAfter(std::string_view before) {
  for (const std::string_view between : {"\u00a0", "\u202f", "–"}) {
    if (before.ends_with(between)) return true;
  }
  return before.empty() || (!isOfWord(before.back()) && before.back() != '.');
}

/// Where a sentence may go on after a unit: "mm.ply" is no unit.
bool endsAt(std::string_view rest) {
  if (rest.empty() || rest.starts_with('\n') || blanksAt(rest) > 0) return true;
  constexpr std::string_view kMarks = ",;:.!?)";
  if (rest.starts_with("।")) return true;
  if (kMarks.find(rest.front()) == std::string_view::npos) return false;
  return rest.size() == 1 || endsAt(rest.substr(1));
}

struct Number {
  double value = 0;
  std::size_t bytes = 0;
};

/// The number that a text begins with, as the language writes it.
std::optional<Number> numberAt(const MessageLanguage& language, std::string_view text) {
  std::string plain;
  std::size_t at = 0;
  for (const std::string_view minus : {"-", "\u2212"}) {
    if (!text.starts_with(minus)) continue;
    plain = "-";
    at = minus.size();
  }
  const auto digit = [&](std::size_t i) { return i < text.size() && isDigit(text[i]); };
  if (!digit(at)) return std::nullopt;
  bool has_point = false;
  while (at < text.size()) {
    const bool is_group = !has_point && text[at] == language.thousands && text[at] != ' ' &&
                          digit(at + 1) && digit(at + 2) && digit(at + 3) && !digit(at + 4);
    const bool is_point = !has_point && text[at] == language.point && digit(at + 1);
    if (is_point) {
      has_point = true;
      plain += '.';
    } else if (digit(at)) {
      plain += text[at];
    } else if (!is_group) {
      break;
    }
    ++at;
  }
  Number found{.value = 0, .bytes = at};
  const auto [end, error] = std::from_chars(plain.data(), plain.data() + plain.size(), found.value);
  constexpr double kMost = 1e9;  // What is longer is no number that one says.
  if (error != std::errc() || std::abs(found.value) > kMost) return std::nullopt;
  return found;
}

/// Numbers with a cross between them, and the unit behind the last.
struct Quantity {
  std::vector<double> values;
  Unit unit;
  std::size_t bytes = 0;
};

std::optional<Quantity> quantityAt(const MessageLanguage& language, std::string_view text) {
  Quantity found;
  std::size_t at = 0;
  for (;;) {
    const auto next = numberAt(language, text.substr(at));
    if (!next) return std::nullopt;
    found.values.push_back(next->value);
    at += next->bytes;
    std::string_view rest = text.substr(at);
    rest.remove_prefix(blanksAt(rest));
    constexpr std::string_view kCross = "×";
    if (!rest.starts_with(kCross)) break;
    rest.remove_prefix(kCross.size());
    rest.remove_prefix(blanksAt(rest));
    at = text.size() - rest.size();
  }
  std::string_view rest = text.substr(at);
  const std::size_t blanks = blanksAt(rest);
  rest.remove_prefix(blanks);
  for (const Unit& unit : kUnits) {
    if (!rest.starts_with(unit.sign)) continue;
    if (!endsAt(rest.substr(unit.sign.size()))) continue;
    // "Room 3N" is a name.
    const bool may_be_close = unit.sign == "%" || unit.sign == "°";
    if (blanks == 0 && !may_be_close) continue;
    found.unit = unit;
    found.bytes = text.size() - rest.size() + unit.sign.size();
    return found;
  }
  return std::nullopt;
}

std::string textOf(const MessageLanguage& language, const Quantity& quantity, bool as_it_is) {
  const Words words_of = as_it_is ? quantity.unit.as_it_is : quantity.unit.words;
  std::string text;
  for (const double value : quantity.values) {
    if (!text.empty()) text += " " + textIn(language, said<MessageId::sayable_by>()) + " ";
    const Message words = words_of(std::abs(value));
    text += value < 0 ? textIn(language, said<MessageId::sayable_minus>(words))
                      : textIn(language, words);
  }
  return text;
}

/// Whether a number without a unit stands just before, as in "312.0, 207.0 mm": both are of one
/// kind then, and one that is rounded or in another unit would be heard as something else.
bool isSecondOfTwo(std::string_view before) {
  while (!before.empty() && before.back() == ' ') before.remove_suffix(1);
  for (const std::string_view between : {",", "–"}) {
    if (!before.ends_with(between)) continue;
    before.remove_suffix(between.size());
    return !before.empty() && isDigit(before.back());
  }
  return false;
}

}  // namespace

std::string spokenUnits(const MessageLanguage& language, std::string_view text) {
  std::string spoken;
  for (std::size_t at = 0; at < text.size();) {
    const std::string_view before = text.substr(0, at);
    const auto quantity =
        mayBeginAfter(before) ? quantityAt(language, text.substr(at)) : std::nullopt;
    if (quantity) {
      spoken += textOf(language, *quantity, isSecondOfTwo(before));
      at += quantity->bytes;
    } else {
      spoken += text[at++];
    }
  }
  return spoken;
}

}  // namespace relievo
