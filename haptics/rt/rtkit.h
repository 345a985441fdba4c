// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace relievo {

/// RealtimeKit, the desktop's service that gives real-time priority to ordinary users: asks it for
/// round-robin scheduling of the calling thread, at most at the priority it hands out. In return
/// the process is limited, see limitRealtimeWork().
/// @return empty: granted; else why not, for people. May block for a second. [thread before a loop]
std::string askRealtimeKit(int priority);

/// Of real-time work without a pause the process's threads may do 0.15 s, then it is ended by
/// SIGXCPU, which can be handled: motors are set to zero (docs/adr/0068). At 0.2 s, the most that
/// RealtimeKit lets pass, by SIGKILL, which cannot. @return false: refused
bool limitRealtimeWork();

}  // namespace relievo
