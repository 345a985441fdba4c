// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace relievo {

/// "0.2.0"
std::string_view programVersion() noexcept;
/// Commit that the program was built from, 40 hexadecimal digits, "-changed" after them if files
/// differed from it; "unknown" if it was built outside a repository.
std::string_view programCommit() noexcept;

/// For `--version`: "relievo 0.2.0" and "commit" with the commit, a line each.
std::string versionLines();

}  // namespace relievo
