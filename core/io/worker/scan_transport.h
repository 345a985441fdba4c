// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <new>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "core/base/task.h"
#include "core/cloud/scan.h"
#include "core/io/las/las_unit.h"
#include "core/io/point_sink.h"
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

/// Puts the points of an answer to their place while they are read, so that the parent can take
/// them meanwhile. @throw Error, AnswerTooLong
class PointsAnswer : public PointSink {
 public:
  /// @param tell  told how many are there
  PointsAnswer(int fd, std::function<void(std::uint64_t)> tell) : fd_(fd), tell_(std::move(tell)) {}
  void expect(std::uint64_t count) override;
  void take(std::span<const std::array<float, 3>> points) override;
  /// The answer, if it is this scan after all. @param scan  with its points, or without those that
  ///                                                        were taken
  void finish(const Scan& scan) const;

 private:
  int fd_;
  std::function<void(std::uint64_t)> tell_;
  std::uint64_t count_ = 0;
};

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

/// Takes the points of an answer that is still being written; what they are is known when all of it
/// is there. [one thread]
class PointsAhead {
 public:
  explicit PointsAhead(int fd) : fd_(fd) {}
  /// Those up to this one. @throw Cancelled
  void take(std::uint64_t ready, const Task& task);
  /// What could be read, from the first on; all finite.
  std::vector<std::array<float, 3>> give() { return std::move(points_); }

 private:
  int fd_;
  std::vector<std::array<float, 3>> points_;
  bool is_good_ = true;  ///< Else the rest waits for the whole answer.
};

/// Reads it in the parent. Nothing (monostate) if there is no complete, consistent answer: sizes
/// must agree, points be finite, indices of triangles, parts and textures in range. A raster's
/// cells stay in the file and are checked as they are read. @throw Cancelled
/// @param ahead  what was taken of it meanwhile
WorkerAnswer receiveAnswer(int fd, const Task& task, PointsAhead ahead);
WorkerAnswer receiveAnswer(int fd, const Task& task);

}  // namespace relievo
