// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <functional>
#include <string_view>

namespace relievo {

/// A control group that this process is in: a container, a batch job, a limited desktop session.
struct ControlGroup {
  std::filesystem::path folder;  ///< Where its limits are.
  bool is_second = true;         ///< Of version 2 of the kernel's groups; else of version 1.
};

/// Calls `look` for the groups of this process whose limits count for `controller` ("memory",
/// "cpu"), from the highest that can be seen downwards. Within a container the path may be that of
/// the machine outside, of which only the end is mounted: then the mount itself is the group. [any
/// thread]
/// @param root  where /proc and /sys are found
void forEachControlGroup(const std::filesystem::path& root, std::string_view controller,
                         const std::function<void(const ControlGroup&)>& look);

/// Cores that this process may keep busy: those it is bound to, and no more than its control groups
/// pay for; at least one. [any thread]
int usableCores(const std::filesystem::path& root = "/");

}  // namespace relievo
