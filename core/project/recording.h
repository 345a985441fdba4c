// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "core/base/task.h"
#include "core/replay/touch_recording.h"

namespace relievo {

/// A recording of the window, of `record` or of `touch`, CSV or HDF5, as a plain value. Windows
/// that the file does not place are left out. [worker]
/// @throw FileError  as readLog; a number that is not finite  @throw Cancelled
TouchRecording readRecording(const std::filesystem::path& file, const Task& task = {});

}  // namespace relievo
