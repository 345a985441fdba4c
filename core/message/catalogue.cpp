// SPDX-License-Identifier: BSD-3-Clause
#include "core/message/catalogue.h"

#include <algorithm>

namespace relievo {
namespace {

consteval bool hasPlace(std::string_view sentence, std::size_t number) {
  const char place[]{'%', static_cast<char>('0' + number), '\0'};
  return sentence.find(place) != std::string_view::npos;
}

/// No argument is without a place: eyes may be told numbers for which ears have words, so that one
/// of the two sentences has it.
consteval bool hasItsPlaces(std::string_view screen, std::string_view spoken,
                            std::size_t arguments) {
  for (std::size_t number = 1; number <= arguments; ++number) {
    if (!hasPlace(screen, number) && !hasPlace(spoken, number)) return false;
  }
  return true;
}

/// Every place of a sentence is one of its arguments.
consteval bool hasNoOtherPlaces(std::string_view sentence, std::size_t arguments) {
  for (std::size_t i = 0; i + 1 < sentence.size(); ++i) {
    const char digit = sentence[i + 1];
    const bool is_place = sentence[i] == '%' && digit >= '1' && digit <= '9';
    if (is_place && static_cast<std::size_t>(digit - '0') > arguments) return false;
  }
  return true;
}

/// Forms of number are "{N|...|...}" of a count.
consteval bool hasItsForms(std::string_view sentence, std::span<const std::size_t> types) {
  for (std::size_t i = 0; i < sentence.size(); ++i) {
    if (sentence[i] == '}') return false;
    if (sentence[i] != '{') continue;
    const std::size_t end = sentence.find('}', i);
    if (end == std::string_view::npos || end < i + 5) return false;
    const std::string_view inner = sentence.substr(i + 1, end - i - 1);
    const std::size_t place = static_cast<std::size_t>(inner[0] - '1');
    if (place >= types.size() || types[place] != typeOfArgument<CountArgument>()) return false;
    if (inner[1] != '|' || std::count(inner.begin(), inner.end(), '|') != 2) return false;
    if (inner.find('{') != std::string_view::npos) return false;
    i = end;
  }
  return true;
}

#define RELIEVO_MESSAGE_ROW(id, kind, code, screen, spoken, ...)                             \
  static_assert(hasItsForms(screen, FormOfMessage<MessageId::id>::kTypes) &&                 \
                    hasItsForms(spoken, FormOfMessage<MessageId::id>::kTypes),               \
                "a form of number of " #id " is none of a count");                           \
  static_assert(hasItsPlaces(screen, spoken, FormOfMessage<MessageId::id>::kTypes.size()) && \
                    hasNoOtherPlaces(screen, FormOfMessage<MessageId::id>::kTypes.size()),   \
                "the sentences of " #id " and its arguments do not fit");                    \
  static_assert(hasNoOtherPlaces(spoken, FormOfMessage<MessageId::id>::kTypes.size()),       \
                "the spoken sentence of " #id " has a place without argument");
#include "core/message/catalogue.inc"
#undef RELIEVO_MESSAGE_ROW

#define RELIEVO_MESSAGE_ROW(id, kind, code, screen, spoken, ...) \
  MessageRow{MessageId::id,                                      \
             #id,                                                \
             MessageKind::kind,                                  \
             code,                                               \
             screen,                                             \
             spoken,                                             \
             FormOfMessage<MessageId::id>::kTypes},
// Of its type, and not of what stands in it: that needs a fold as deep as there are rows, at which
// clang ends.
constexpr auto kRows = std::to_array<MessageRow>({
#include "core/message/catalogue.inc"
});
#undef RELIEVO_MESSAGE_ROW

}  // namespace

std::span<const MessageRow> messageRows() {
  return kRows;
}

const MessageRow& rowOf(MessageId id) {
  return kRows.at(static_cast<std::size_t>(id));
}

}  // namespace relievo
