// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <stop_token>
#include <string_view>

#include "core/base/error.h"

namespace relievo {

/// How a long computation reports and stops. Default: silent, never stops.
/// Long work calls `check()` at least every 50 ms.
struct Task {
  std::stop_token stop;
  /// Called on the computing thread: what is being done, and how far, [0, 1].
  std::function<void(std::string_view step, double fraction)> progress;

  /// @throw Cancelled  if stopping was requested
  void check() const {
    if (stop.stop_requested()) throwCancelled();
  }
  void report(std::string_view step, double fraction) const {
    if (progress) progress(step, fraction);
  }

 private:
  [[noreturn]] static void throwCancelled();
};

}  // namespace relievo
