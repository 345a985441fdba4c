// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/message/message.h"

namespace relievo::batch {

inline constexpr const char* kForceDimension = "force_dimension";  ///< The plug-in's name.

/// Where the maker's library of a plug-in lies, as the user has named it, for the window as for
/// the command line. Empty: where such libraries usually are.
std::filesystem::path makersLibrary(const std::string& plugin);
/// From the next start of the plug-in on; empty: the usual places again.
/// @throw FileError  there is no such file  @throw WriteError
void setMakersLibrary(const std::string& plugin, const std::filesystem::path& library);

/// A plug-in for devices that was found, and whether it may run.
struct DevicePlugin {
  std::string name;
  std::filesystem::path file;
  bool allowed = false;
  bool can_be_allowed = false;  ///< It is the user's own: allowing it is for the user to do.
  std::optional<Message> why_not;
};
/// None of them is run; the user's own are read. [worker]
std::vector<DevicePlugin> devicePlugins();
/// Where the user's own lie.
std::filesystem::path ownDevicePlugins();
/// From now on it may run, as it is, or not any more. [worker] @return the file's SHA-256, if it
/// may
/// @throw DeviceError, FileError, WriteError
std::string allowDevicePlugin(const std::filesystem::path& file, bool allowed);

}  // namespace relievo::batch
