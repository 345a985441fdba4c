// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "haptics/rt/realtime.h"

namespace relievo::falcon {

/// While it lives, a process that calls exit(), ends by any signal but SIGKILL, or is halted by any
/// but SIGSTOP, sends its Falcon zero force first. Signals that something else handles are left
/// alone. The handler makes two system calls and then lets the signal do what it would have done,
/// on the thread's signal stack if it has one (haptics/rt/signal_stack.h). One at a time: a process
/// has one set of signal handlers (docs/adr/0027, 0068).
class EmergencyStop {
 public:
  /// @param descriptor  of the open usbfs node
  explicit EmergencyStop(int descriptor);
  ~EmergencyStop();
  EmergencyStop(const EmergencyStop&) = delete;
  EmergencyStop& operator=(const EmergencyStop&) = delete;

  /// They were said: nothing may be sent after them.
  static bool spoken() RELIEVO_REALTIME;
};

}  // namespace relievo::falcon
