// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>

namespace relievo::architecture {

/// Text of every hand-written file of the tree whose name `wanted` accepts, by its path from the
/// root. Build folders, samples and version control are left out.
std::map<std::string, std::string> readTree(bool (*wanted)(const std::string& path));

bool isCpp(const std::string& path);   ///< .h or .cpp
bool isText(const std::string& path);  ///< Anything people write: sources, CMake, scripts, pages.

}  // namespace relievo::architecture
