// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/file/owned_fd.h"

namespace relievo {

/// A pipe whose reading end does not wait; its writing end is above the numbers a child uses.
/// @throw FileError  the system refuses
void makePipe(OwnedFd& read_end, OwnedFd& write_end);

/// Moves a descriptor above those numbers, so that dup2 in a child overwrites nothing.
/// @throw FileError  it is none, or the system refuses
int raised(int fd);

/// Appends what is there. @return  false once the other end is closed
bool readAvailable(int fd, std::string& text);

/// The last line with something to read in it, without the colours that programs print.
std::string lastPrintableLine(std::string_view text);

struct FdForChild {
  int fd = -1;  ///< Ours.
  int as = 0;   ///< Its number in the child.
};

struct ProgramStart {
  std::filesystem::path program;       ///< No search, no shell.
  std::vector<std::string> arguments;  ///< With the name it is called by.
  std::vector<std::string> more_environment;
  /// Nothing: ours in the C locale. More is added in both cases.
  std::optional<std::vector<std::string>> environment = std::nullopt;
  std::vector<FdForChild> fds;
};

/// A child in a process group of its own (^C reaches us, not it), in the C locale, without
/// standard input, no signal blocked or ignored. Killed with its group and reaped by the
/// destructor, if still running.
class ChildProcess {
 public:
  ChildProcess() = default;
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// @throw FileError  the system refuses
  void start(ProgramStart how);
  /// @return  true once it has ended
  bool reap(bool wait);
  /// Can be read once it has ended, for poll; -1: the system has no such thing.
  int endFd() const noexcept { return end_.get(); }
  void kill();

  /// How the child came to its end, once it has.
  bool exited() const noexcept;  ///< Else a signal killed it.
  int number() const noexcept;   ///< Exit status or signal.

 private:
  int pid_ = -1;  ///< -1: none, or reaped.
  OwnedFd end_;
  int status_ = 0;
};

}  // namespace relievo
