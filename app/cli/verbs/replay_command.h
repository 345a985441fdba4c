// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/cli/verbs/touch_setup.h"
#include "core/provenance/sha256.h"
#include "core/recording/log_table.h"

namespace relievo::batch {

/// The command `touch` or `record` that made a log, as its header tells; nothing: another made it.
std::optional<std::vector<std::string>> commandIn(const LogTable& log);
/// @throw FileError  nothing tells what made it; names `file`
std::vector<std::string> commandOf(const LogTable& log, const std::string& file);

/// The address of a map stays one: no server is asked.
/// @throw FileError  this version does not understand it
TouchArguments argumentsOf(const std::vector<std::string>& command);

/// With how many newtons the grip was held, whatever the settings say now.
double liftIn(const LogTable& log);
/// What a plug-in's device told of itself then; nothing: it was another device.
std::optional<DeviceInfo> toldIn(const LogTable& log);
/// The raster of firm ground that the command named, with the checksum it had; nothing: none.
/// @throw FileError  as argumentsOf
std::optional<InputFile> firmnessOfCommand(const LogTable& log);

}  // namespace relievo::batch
