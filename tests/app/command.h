// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace relievo::test {

struct CommandResult {
  int exit_code = -1;  ///< 128 + signal if the program was killed.
  std::string out, err;
};

enum class RunAs {
  self,
  nobody,  ///< An account without rights where this one is root's; else the same as `self`.
};

/// Runs the built `relievo` with these arguments and waits for it.
/// @param environment  additional "NAME=value"; "NAME" alone removes the variable
CommandResult runRelievo(const std::vector<std::string>& arguments,
                         const std::vector<std::string>& environment = {}, RunAs as = RunAs::self);

}  // namespace relievo::test
