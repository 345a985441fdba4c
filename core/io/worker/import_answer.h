// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "core/io/import.h"
#include "core/io/worker/scan_transport.h"
#include "core/io/worker/worker_process.h"

namespace relievo {

/// Asks an import program, and another one if the first says so. [worker]
/// @return  anything but a refusal, or nothing; whoever asked looks whether it is what was wanted
/// @throw FileError, ArgumentError  what the program refuses with; it broke down  @throw Cancelled
WorkerAnswer importAnswer(ImportAsk ask, const Task& task);

/// The program has ended without an answer that makes sense.
[[noreturn]] void refuseEnd(const std::filesystem::path& file, const ImportOptions& options,
                            const WorkerEnd& end);
[[noreturn]] void throwRefusal(const WorkerRefusal& refusal);

}  // namespace relievo
