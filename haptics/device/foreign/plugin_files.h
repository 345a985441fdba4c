// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/message/message.h"
#include "haptics/device/device.h"
#include "haptics/device/foreign/plugin_image.h"

namespace relievo::foreign {

/// One file that may be a plug-in for devices. Nothing of it was run.
struct PluginFile {
  std::string name;  ///< Without folder and ".so": the FILE of "plugin:FILE/ID".
  std::filesystem::path file;
  bool own = false;  ///< It lies in the user's own folder: who may run is the user's to say.
  /// It lies where only an administrator writes, where RELIEVO_DEVICE_PATH says, or the user
  /// allowed exactly these bytes; and nobody else may change it.
  bool trusted = false;
  std::optional<Message> why_not;  ///< Of one that is not.
};

/// Where they are looked for, in this order; of two of one name the first counts.
struct PluginPlaces {
  std::vector<std::filesystem::path> trusted;
  std::filesystem::path own;   ///< The user's: each file must be allowed once.
  std::filesystem::path list;  ///< Checksums of those that were.
};
/// RELIEVO_DEVICE_PATH (folders with colons between them), the folder of the installation; the
/// user's data and settings folders. [any one thread]
PluginPlaces pluginPlaces();

/// By name, which is of letters, digits, '.', '_', '+' and '-': other files are none. Empty where
/// no folder has any; no file is run, none but the user's own is read.
std::vector<PluginFile> pluginFiles(const PluginPlaces& places = pluginPlaces());

/// What may run of one, read and judged at once. [worker]
/// @throw DeviceError  it is not trusted  @throw FileError  it cannot be read
PluginImage trustedImage(const PluginFile& plugin, const PluginPlaces& places = pluginPlaces());

/// From now on this file, as it is, may run. @return its checksum
/// @throw DeviceError  others may change it  @throw FileError, WriteError
std::string trustPlugin(const std::filesystem::path& file,
                        const PluginPlaces& places = pluginPlaces());

/// From now on neither this file nor an earlier form of it may run, until it is allowed again. One
/// that is gone may be named, too.
/// @throw DeviceError  it was not allowed  @throw WriteError
void distrustPlugin(const std::filesystem::path& file, const PluginPlaces& places = pluginPlaces());

/// The closed device "plugin:FILE/ID".
/// @throw DeviceError  no such name or file, or it is not trusted
std::unique_ptr<Device> makePluginDevice(const std::string& id,
                                         const PluginPlaces& places = pluginPlaces());

inline constexpr const char* kPluginKind = "plugin";

}  // namespace relievo::foreign
