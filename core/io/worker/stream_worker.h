// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/io/import.h"
#include "core/io/point_stream.h"
#include "core/io/worker/scan_transport.h"

namespace relievo {

/// PointStream's arguments of the process.
struct StreamSetup {
  int channels = 1;
  StreamedParts parts = StreamedParts::places;
};
std::vector<std::string> argumentsOf(const StreamSetup& setup);
/// Nothing: they are none.
std::optional<StreamSetup> streamSetupOf(std::span<const std::string> arguments);

/// The process's side of a PointStream: answers with its head, then serves every channel until the
/// other end is closed. [worker process]
/// @param refusal  of the exception in flight
/// @throw Error  the file is refused before anything was answered
void servePoints(const std::filesystem::path& file, const ImportOptions& options,
                 const StreamSetup& setup, const Task& task,
                 const std::function<WorkerRefusal()>& refusal);

/// How a head travels.
WorkerText textOf(const PointStreamHead& head);
/// Nothing: it makes no sense.
std::optional<PointStreamHead> streamHeadOf(const WorkerText& text);

}  // namespace relievo
