// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <stdexcept>
#include <string>

namespace relievo {

struct Message;

/// Root of everything this project throws. `what()` is one sentence or two for people, in English:
/// what happened, what the program did, what you can do. `code` names the sentence in manuals
/// ("E101") or is empty.
struct Error : std::runtime_error {
  /// A sentence that is not in the catalogue; a window shows it in English.
  explicit Error(const std::string& sentence, std::string code_of_catalogue = {})
      : std::runtime_error(sentence), code(std::move(code_of_catalogue)) {}
  /// A message of the catalogue (core/message), which says its sentence and its code.
  explicit Error(const Message& of_catalogue);
  std::string code;
  /// What a window renders in its own language; absent where the sentence is not in the catalogue.
  std::shared_ptr<const Message> message;
};

struct ArgumentError : Error {
  using Error::Error;
};  ///< Caller broke a stated precondition. Exit 1.
struct FileError : Error {
  using Error::Error;
};  ///< Missing, unreadable or malformed. Exit 2.
struct WriteError : Error {
  using Error::Error;
};  ///< Cannot write a result. Exit 3.
struct DeviceError : Error {
  using Error::Error;
};  ///< Absent, busy or misbehaving. Exit 6.
struct GraphicsError : Error {
  using Error::Error;
};  ///< No graphics to draw with. Exit 7.
struct Cancelled : Error {
  using Error::Error;
};  ///< The stop token was triggered. Exit 130.

}  // namespace relievo
