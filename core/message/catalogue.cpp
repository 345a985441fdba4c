// SPDX-License-Identifier: BSD-3-Clause
#include "core/message/catalogue.h"

#include <algorithm>

namespace relievo {
namespace {

/// Every place of a sentence is one of its arguments, and no argument is without a place.
consteval bool hasItsPlaces(std::string_view sentence, std::size_t arguments) {
  std::size_t highest = 0;
  for (std::size_t i = 0; i + 1 < sentence.size(); ++i) {
    const char digit = sentence[i + 1];
    if (sentence[i] == '%' && digit >= '1' && digit <= '9') {
      highest = std::max(highest, static_cast<std::size_t>(digit - '0'));
    }
  }
  if (highest != arguments) return false;
  for (std::size_t number = 1; number <= arguments; ++number) {
    const char place[]{'%', static_cast<char>('0' + number), '\0'};
    if (sentence.find(place) == std::string_view::npos) return false;
  }
  return true;
}

/// A spoken sentence may leave arguments out, but has no others.
consteval bool hasNoOtherPlaces(std::string_view sentence, std::size_t arguments) {
  for (std::size_t i = 0; i + 1 < sentence.size(); ++i) {
    const char digit = sentence[i + 1];
    const bool is_place = sentence[i] == '%' && digit >= '1' && digit <= '9';
    if (is_place && static_cast<std::size_t>(digit - '0') > arguments) return false;
  }
  return true;
}

#define RELIEVO_MESSAGE_ROW(id, kind, code, screen, spoken, ...)                       \
  static_assert(hasItsPlaces(screen, FormOfMessage<MessageId::id>::kTypes.size()),     \
                "the sentence of " #id " and its arguments do not fit");               \
  static_assert(hasNoOtherPlaces(spoken, FormOfMessage<MessageId::id>::kTypes.size()), \
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
constexpr std::array kRows{
#include "core/message/catalogue.inc"
};
#undef RELIEVO_MESSAGE_ROW

}  // namespace

std::span<const MessageRow> messageRows() {
  return kRows;
}

const MessageRow& rowOf(MessageId id) {
  return kRows.at(static_cast<std::size_t>(id));
}

}  // namespace relievo
