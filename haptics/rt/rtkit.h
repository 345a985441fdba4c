// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace relievo {

/// RealtimeKit, the desktop's service that gives real-time priority to ordinary users: asks it for
/// round-robin scheduling of the calling thread, at most at the priority it hands out. In return
/// the process is limited to 0.2 s of real-time work without a pause.
/// @return empty: granted; else why not, for people. May block for a second. [thread before a loop]
std::string askRealtimeKit(int priority);

}  // namespace relievo
