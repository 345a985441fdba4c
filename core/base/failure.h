// SPDX-License-Identifier: BSD-3-Clause
// How a message of the catalogue is thrown. Only .cpp files include this.
#pragma once

#include <exception>
#include <utility>

#include "core/base/error.h"
#include "core/message/catalogue.h"

namespace relievo {

template <MessageKind>
struct ErrorOfKind;  // A note is not thrown.
template <>
struct ErrorOfKind<MessageKind::argument> {
  using Type = ArgumentError;
};
template <>
struct ErrorOfKind<MessageKind::file> {
  using Type = FileError;
};
template <>
struct ErrorOfKind<MessageKind::write> {
  using Type = WriteError;
};
template <>
struct ErrorOfKind<MessageKind::device> {
  using Type = DeviceError;
};
template <>
struct ErrorOfKind<MessageKind::graphics> {
  using Type = GraphicsError;
};
template <>
struct ErrorOfKind<MessageKind::cancelled> {
  using Type = Cancelled;
};

/// `throw failure<MessageId::file_missing>(path);`: of the class that the table says, so that a
/// sentence has one exit code wherever it is thrown.
template <MessageId message_id, class... Given>
[[nodiscard]] auto failure(Given&&... given) {
  using Thrown = typename ErrorOfKind<FormOfMessage<message_id>::kKind>::Type;
  return Thrown(said<message_id>(std::forward<Given>(given)...));
}

/// What an error says, to be quoted in another message.
Message messageOf(const std::exception& error);

}  // namespace relievo
