// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <vector>

#include "core/base/task.h"
#include "core/provenance/sha256.h"

namespace relievo::batch {

/// The files that a replay of a recording needs beside the scan it was begun on: rasters of firm
/// ground and, with `scans`, other scans that were touched. Each is where the recording says or
/// beside it; its checksum is the one that was noted, whatever the file holds now. [worker]
/// @throw FileError  no recording, or (E501) a file is nowhere there  @throw Cancelled
std::vector<InputFile> dependenciesOf(const std::filesystem::path& recording, bool scans,
                                      const Task& task);

}  // namespace relievo::batch
