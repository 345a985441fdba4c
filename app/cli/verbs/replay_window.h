// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "app/cli/state.h"
#include "core/base/task.h"
#include "haptics/record/replay.h"

namespace relievo::batch {

/// A recording, and where what it names is looked for.
struct RecordingPlace {
  std::string file;
  std::string input = {};  ///< The scan; empty: found by the state that the recording carries.
  /// Of the unpacked package that it comes from, in which all that it names has to be; empty: it
  /// comes from none.
  std::filesystem::path package_folder = {};
  OutsideFiles outside_files = OutsideFiles::refuse;
};

/// Replays a recording that began in the running loop of a window: every surface is prepared again
/// and checked.
/// @return nothing: it is no such recording
/// @throw FileError  its state is in no form that this build reads, the scan has changed, or
/// samples were dropped
std::optional<ReplayResult> replayOfWindow(
    const LogTable& log, const RecordingPlace& place,
    const std::function<void(const HapticSample&, double t_s)>& each, const Task& task);

}  // namespace relievo::batch
