// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <new>
#include <string>
#include <variant>

#include "core/base/task.h"
#include "core/cloud/scan.h"
#include "core/io/las/las_unit.h"
#include "core/io/raster/raster.h"
#include "core/io/raster/raster_rows.h"
#include "core/io/worker/worker_process.h"

namespace relievo {

/// Why a worker has nothing to give: an Error for the caller of importScan or importRaster.
struct WorkerRefusal {
  std::string message, code;
  std::string of_catalogue = {};  ///< The same as messageBytes; empty: it is not in the catalogue.
};

/// An answer is longer than files may be where this runs.
class AnswerTooLong : public std::bad_alloc {
 public:
  explicit AnswerTooLong(std::uint64_t most_bytes) : most_bytes_(most_bytes) {}
  std::uint64_t mostBytes() const noexcept { return most_bytes_; }  ///< That a file may have.

 private:
  std::uint64_t most_bytes_;
};

/// @throw AnswerTooLong  a file, in memory too, could not become longer (EFBIG)
[[noreturn]] void refuseLength();

/// Writes the worker's answer over whatever a file held. @throw Error, AnswerTooLong
void sendAnswer(int fd, const Scan& scan);
void sendAnswer(int fd, const WorkerRefusal& refusal);

/// Writes the answer of a raster while it is read: `sink`, then `finish`.
/// @throw Error  also if the disk has no room; AnswerTooLong
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

/// What is said by a Packer; whoever asked knows what it is to be.
struct WorkerText {
  std::string bytes;
};
void sendAnswer(int fd, const WorkerText& text);

/// A scan of LAS that names its system and no unit (addUnitOfSystem).
struct ScanOfSystem {
  Scan scan;
  LasSystem system;
};
void sendAnswer(int fd, const ScanOfSystem& scan);

/// Another of the import programs is to read the file.
struct OtherProgram {
  ImportProgram program = ImportProgram::own;
};
void sendAnswer(int fd, const OtherProgram& other);

using WorkerAnswer = std::variant<std::monostate, Scan, ScanOfSystem, RasterRows, WorkerText,
                                  OtherProgram, WorkerRefusal>;

/// Reads it in the parent. Nothing (monostate) if there is no complete, consistent answer: sizes
/// must agree, points be finite, indices of triangles, parts and textures in range. A raster's
/// cells stay in the file and are checked as they are read. @throw Cancelled
WorkerAnswer receiveAnswer(int fd, const Task& task);

}  // namespace relievo
