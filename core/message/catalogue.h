// SPDX-License-Identifier: BSD-3-Clause
// The names of the messages, and how one is made. Only .cpp files include this: a new message then
// compiles again what says messages, and nothing else.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>

#include "core/message/message.h"

namespace relievo {

enum class MessageId : std::uint16_t {
#define RELIEVO_MESSAGE_ROW(id, ...) id,
#include "core/message/catalogue.inc"
#undef RELIEVO_MESSAGE_ROW
};

/// What a message is thrown as, which is the program's exit code; core/base/failure.h throws it.
enum class MessageKind : std::uint8_t {
  note,  ///< Said, not thrown: news, or a part of another message.
  argument,
  file,
  write,
  device,
  graphics,
  cancelled
};

/// Which of the types of MessageArgument.
template <class Argument, std::size_t from = 0>
consteval std::size_t typeOfArgument() {
  if constexpr (std::is_same_v<Argument, std::variant_alternative_t<from, MessageArgument>>) {
    return from;
  } else {
    return typeOfArgument<Argument, from + 1>();
  }
}

/// Makes a message whose arguments are of these types, in this order.
template <MessageKind message_kind, class... Arguments>
struct MessageForm {
  static constexpr MessageKind kKind = message_kind;
  static constexpr std::array<std::size_t, sizeof...(Arguments)> kTypes{
      typeOfArgument<Arguments>()...};
  static Message message(MessageId id, Arguments... arguments) {
    Message made{id, {}};
    made.arguments.reserve(sizeof...(Arguments));
    (made.arguments.emplace_back(std::move(arguments)), ...);
    return made;
  }
};

template <MessageId>
struct FormOfMessage;

#define RELIEVO_MESSAGE_ROW(id, kind, code, screen, spoken, ...) \
  template <>                                                    \
  struct FormOfMessage<MessageId::id>                            \
      : MessageForm<MessageKind::kind __VA_OPT__(, ) __VA_ARGS__> {};
#include "core/message/catalogue.inc"
#undef RELIEVO_MESSAGE_ROW

/// `said<MessageId::file_missing>(path)`. Arguments that the sentence does not have, too few of
/// them, or others than it names do not compile.
template <MessageId message_id, class... Given>
requires requires(Given&&... given) {
  FormOfMessage<message_id>::message(message_id, std::forward<Given>(given)...);
}
[[nodiscard]] Message said(Given&&... given) {
  return FormOfMessage<message_id>::message(message_id, std::forward<Given>(given)...);
}

/// A row of the table, for whoever renders messages and for tests.
struct MessageRow {
  MessageId id;
  std::string_view name;  ///< As in the enumeration.
  MessageKind kind;
  std::string_view code;  ///< "E101", or nothing.
  const char* screen;     ///< English, with %1 to %9.
  const char* spoken;     ///< For ears, in a dozen words; empty where `screen` will do.
  std::span<const std::size_t> arguments;  ///< Their types, as MessageArgument::index() says them.
};

/// What translations of the table are filed under.
inline constexpr const char* kMessageContext = "relievo::Message";

/// By number of id.
std::span<const MessageRow> messageRows();
const MessageRow& rowOf(MessageId id);

}  // namespace relievo
