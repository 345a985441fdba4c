// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/file/owned_fd.h"

namespace relievo::foreign {

/// The program that loads plug-ins, as a child in a process group of its own: ^C reaches us, not
/// it. It ends by itself when the pipe that this holds is closed, however we end.
class HostProcess {
 public:
  HostProcess() = default;
  ~HostProcess();  ///< Killed if it still runs.
  HostProcess(const HostProcess&) = delete;
  HostProcess& operator=(const HostProcess&) = delete;

  struct Start {
    std::vector<std::string> arguments;  ///< Without the program's name.
    /// It gets this process's environment and these, as "NAME=VALUE".
    std::vector<std::string> variables{};
    int shared_fd = -1;  ///< Its descriptor 3; this one stays ours.
    int plugin_fd = -1;  ///< Its descriptor 5, a PluginImage's; likewise.
    int output_fd = -1;  ///< Its standard output; -1: it goes to standard error.
  };
  /// @throw FileError  the program is not installed, or may not be found
  /// @throw DeviceError  the system refuses
  void start(const Start& how);

  /// @return true once it has ended; waits at most so long
  bool ended(int wait_ms) noexcept;
  /// It is told to end: its end of the pipe. Motors to zero, then it goes.
  void letGo() noexcept { life_.reset(); }
  void kill() noexcept;

  bool crashed() const noexcept { return signal_ != 0; }  ///< Of one that has ended.
  int signal() const noexcept { return signal_; }
  int exitStatus() const noexcept { return exit_status_; }
  int pid() const noexcept { return pid_; }

 private:
  OwnedFd life_, pidfd_;
  int pid_ = -1;
  int signal_ = 0, exit_status_ = 0;
};

}  // namespace relievo::foreign
