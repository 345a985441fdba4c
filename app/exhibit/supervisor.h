// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace relievo {

/// What is started, and how long it may be silent.
struct SupervisorOptions {
  std::vector<std::string> command;  ///< The program and its arguments.
  std::filesystem::path log;         ///< Gets a line for each start and end.
  double first_beat_s =
      60;                ///< Until the first heartbeat; reading of the first object is none of it.
  double silence_s = 4;  ///< Between two of them.
  double abort_s = 1;    ///< From SIGABRT, on which a device gets zero force, to SIGKILL.
};

/// Starts a program with a pipe for heartbeats ($RELIEVO_HEARTBEAT_FD) and starts it again, with
/// $RELIEVO_EXHIBIT_STARTS one more, whenever it ends unexpectedly or is silent: within 10 s of a
/// crash, and of a hang. It ends with the program where that was meant: exit status 0, misuse, a
/// file that cannot be read, no display; on a signal that asks it to end it ends the program first.
/// Told by systemd to notify, it does. [main thread]
/// @return exit code; 4: it was given up, and a sentence on stderr says so
int supervise(const SupervisorOptions& options);

/// The exhibit of a file, supervised. @param arguments  of the command line, for the window
/// @throw FileError  the file cannot be used
int runExhibit(const std::filesystem::path& file, const std::vector<std::string>& arguments);

}  // namespace relievo
