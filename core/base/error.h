// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>
#include <string>

namespace relievo {

/// Root of everything this project throws; caught at a GUI task, plugin attach, thread top or
/// batch main, and nowhere else. `what()` is one sentence or two for people: what happened, what
/// the program did, what you can do. `code` names a message of the catalogue ("E101") or is empty.
struct Error : std::runtime_error {
  explicit Error(const std::string& message, std::string code_of_catalogue = {})
      : std::runtime_error(message), code(std::move(code_of_catalogue)) {}
  std::string code;
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
