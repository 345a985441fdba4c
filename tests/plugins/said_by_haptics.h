// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <set>
#include <string>

namespace relievo::test {

struct SaidByHaptics {
  std::set<std::string> sentences;
  /// Names of files, hashes and the system's reasons in them: parts that are in no language.
  std::set<std::string> names;
};

/// Every sentence that haptics has for a window, from the code that says it: each fault, state and
/// mistake is brought about.
SaidByHaptics saidByHaptics();

}  // namespace relievo::test
