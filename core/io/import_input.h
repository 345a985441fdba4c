// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <variant>

#include "core/base/task.h"
#include "core/cloud/scan.h"
#include "core/io/import.h"
#include "core/io/input_facts.h"

namespace relievo {

/// A scan, or what a file is that holds none: inputFacts and importScan by one process, which takes
/// some milliseconds less. [worker]
/// @throw FileError, ArgumentError, Cancelled  as those two
std::variant<Scan, InputFacts> importInput(const std::filesystem::path& file,
                                           const ImportOptions& options = {},
                                           const Task& task = {});

}  // namespace relievo
