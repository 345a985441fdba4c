// SPDX-License-Identifier: BSD-3-Clause
#include "core/base/background.h"

#include <sys/resource.h>

namespace relievo {
namespace {
constexpr int kNice = 5;  // A third of what a picture gets: nobody starves on a busy computer.
}

void workInBackground() noexcept {
  // On Linux, of the thread, not of the process (setpriority(2), "C library/kernel differences").
  if (::getpriority(PRIO_PROCESS, 0) < kNice) ::setpriority(PRIO_PROCESS, 0, kNice);
}

}  // namespace relievo
