// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <variant>

#include "core/base/task.h"
#include "core/cloud/scan.h"
#include "core/io/raster.h"

namespace relievo {

/// Why a worker has nothing to give: an Error for the caller of importScan or importRaster.
struct WorkerRefusal {
  std::string message, code;
};

/// Writes the worker's answer to the start of an empty memory file. @throw Error
void sendAnswer(int memory_fd, const Scan& scan);
void sendAnswer(int memory_fd, const RasterMap& raster);
void sendAnswer(int memory_fd, const WorkerRefusal& refusal);

using WorkerAnswer = std::variant<std::monostate, Scan, RasterMap, WorkerRefusal>;

/// Reads it in the parent. Nothing (monostate) if there is no complete, consistent answer: sizes
/// must agree, points and valid cells be finite, triangle indices and origins in range.
/// @throw Cancelled
WorkerAnswer receiveAnswer(int memory_fd, const Task& task);

}  // namespace relievo
