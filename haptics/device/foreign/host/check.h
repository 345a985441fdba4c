// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace relievo::foreign {

struct CheckAsk {
  std::string file, code;
  std::string device;  ///< Its id; empty: none.
  double seconds = 1;  ///< How long steps are watched.
};

/// Runs one test of kChecks, none of which pushes, and says its verdict in one line on the answer's
/// descriptor: "passed", "failed" or "skipped", and after a tab why. @return the exit status
int check(const CheckAsk& ask);

/// Allocations of the calling thread so far; -1: they are not counted in this build. [any thread]
long allocations() noexcept;

}  // namespace relievo::foreign
