// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "core/base/task.h"
#include "haptics/record/replay.h"

namespace relievo::batch {

/// Replays a recording that began in the running loop of a window: the scan is found by the state
/// that it carries (or is `input`), every surface is prepared again and checked.
/// @param package_folder  of the unpacked package that it comes from, in which all that it names
///                        has to be; empty: it comes from none
/// @return nothing: it is no such recording
/// @throw FileError  its state is in no form that this build reads, the scan has changed, or
/// samples were dropped
std::optional<ReplayResult> replayOfWindow(
    const LogTable& log, const std::string& file, const std::string& input,
    const std::function<void(const HapticSample&, double t_s)>& each,
    const std::filesystem::path& package_folder, const Task& task);

}  // namespace relievo::batch
