// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace relievo {

/// A shared library that is loaded when it is first needed, so that a program starts where it is
/// not installed. It stays loaded. [any thread]
class LateLibrary {
 public:
  /// @param name  as the system's loader finds it: "libusb-1.0.so.0"
  explicit LateLibrary(const char* name);

  bool isThere() const noexcept { return problem_.empty(); }
  /// Why it is not, in the system's words.
  const std::string& problem() const noexcept { return problem_; }
  /// Its function of that name. A library without one counts as one that is not there.
  template <class Function>
  void find(const char* name, Function*& function) {
    function = reinterpret_cast<Function*>(addressOf(name));
  }

 private:
  void* addressOf(const char* name);

  void* handle_;
  std::string problem_;
};

}  // namespace relievo
