// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "core/base/task.h"
#include "haptics/rt/sleep_watch.h"

namespace relievo::falcon {
class FalconDevice;
}

namespace relievo::haply {
class HaplyDevice;
}

namespace relievo::batch {

constexpr int kDeviceExit = 6;

/// Tells every new state and mark on stderr until an opened Falcon is ready.
/// @param undone  "nothing was tried"
/// @throw DeviceError  it is not after `seconds`, or never will be, and why  @throw Cancelled
void waitUntilReady(falcon::FalconDevice& device, double seconds, const std::string& undone,
                    const Task& task);

/// The same of an opened device of Haply.
void waitUntilReady(haply::HaplyDevice& device, double seconds, const Task& task);

/// Keeps the computer awake until the motors of a command's device are at zero. [one thread]
class EndBeforeSleep {
 public:
  /// To be asked once a tick. @return true: it is about to sleep, and forces must end now
  bool wanted() { return watch_.poll() == SleepWatch::News::about_to_sleep; }
  void atZero() { watch_.letSleep(); }

 private:
  SleepWatch watch_;
};

}  // namespace relievo::batch
