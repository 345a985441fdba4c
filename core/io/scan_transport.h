// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <variant>

#include "core/base/task.h"
#include "core/cloud/scan.h"
#include "core/io/raster.h"
#include "core/io/raster_rows.h"

namespace relievo {

/// Why a worker has nothing to give: an Error for the caller of importScan or importRaster.
struct WorkerRefusal {
  std::string message, code;
};

/// Writes the worker's answer over whatever a file held. @throw Error, std::bad_alloc  (the file
/// may not grow so large)
void sendAnswer(int fd, const Scan& scan);
void sendAnswer(int fd, const WorkerRefusal& refusal);

/// Writes the answer of a raster while it is read: `sink`, then `finish`.
/// @throw Error  also if the disk has no room; std::bad_alloc
class RasterAnswer {
 public:
  explicit RasterAnswer(int fd) : fd_(fd) {}
  RasterSink sink();
  void finish(const RasterEnd& end);

 private:
  void begin(const RasterHead& head, bool has_origins);
  int fd_;
  GridSize size_;
};

using WorkerAnswer = std::variant<std::monostate, Scan, RasterRows, WorkerRefusal>;

/// Reads it in the parent. Nothing (monostate) if there is no complete, consistent answer: sizes
/// must agree, points be finite, indices of triangles, parts and textures in range. A raster's
/// cells stay in the file and are checked as they are read. @throw Cancelled
WorkerAnswer receiveAnswer(int fd, const Task& task);

}  // namespace relievo
