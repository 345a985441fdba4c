// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/task.h"
#include "core/cloud/scan.h"
#include "core/file/owned_fd.h"
#include "core/io/formats/ply_header.h"
#include "core/io/formats/scalar.h"
#include "core/io/import.h"
#include "core/io/las/las_unit.h"
#include "core/io/las/laz_points.h"
#include "core/io/point_columns.h"
#include "core/io/point_stream.h"

namespace relievo {

/// Bytes before the points, if points and all that comes before them have records of fixed size.
std::optional<std::uint64_t> bytesBeforePoints(const PlyHeader& header);

/// What PointStream gives, read in this process: the import program's side of it. [worker process]
class PointReader {
 public:
  /// Reads the header only, and the list of chunks of LAZ and COPC. Of `options` max_points does
  /// not apply.
  /// @param task  also stops `read` of LAZ and COPC
  /// @throw FileError  malformed, or incomplete (E101) unless accepted; LAZ that is cut
  explicit PointReader(const std::filesystem::path& file, const ImportOptions& options = {},
                       const Task& task = {}, StreamedParts parts = StreamedParts::places);

  /// All that is said of the points before any is read.
  const PointStreamHead& head() const noexcept { return head_; }
  const ScanInfo& info() const noexcept { return head_.info; }

  /// Heights are in another unit than the file says: those read from now on, and the stated box,
  /// are multiplied. [before other threads read]
  void convertHeights(double factor) noexcept;

  /// As PointStream::read. [any thread] @throw FileError
  std::size_t read(std::uint64_t first, std::span<FilePoint> block,
                   std::span<StoredValues> values = {}) const;

  /// As PointStream::cheapSample.
  std::vector<PointRange> cheapSample(std::uint64_t points) const;

 private:
  struct Coordinate {
    std::size_t offset = 0;  ///< In the record.
    ScalarType type = ScalarType::i32;
    double scale = 1, shift = 0;
  };

  void openLas(const ImportOptions& options, const Task& task, StreamedParts parts);
  void openPly(const ImportOptions& options);
  void setFound(std::uint64_t promised, const ImportOptions& options);
  void setPoints(std::uint64_t found, std::uint64_t promised, const ImportOptions& options);
  void readRecords(std::uint64_t first, std::size_t count, std::vector<char>& buffer) const;
  FilePoint pointOf(const char* record) const noexcept;
  StoredValues valuesOf(const char* record) const noexcept;

  PointStreamHead head_;
  std::shared_ptr<const LazPoints> packed_;  ///< Of LAZ and COPC.
  std::shared_ptr<const OwnedFd> fd_;
  std::uint64_t file_bytes_ = 0;
  std::uint64_t points_at_ = 0;
  std::size_t record_bytes_ = 1;  ///< Those that are read.
  ByteOrder order_ = ByteOrder::little;
  std::array<Coordinate, 3> coordinates_;
  std::optional<std::array<StoredNumber, 3>> colour_;
  std::optional<StoredNumber> intensity_;
  std::uint8_t withheld_bit_ = 0;  ///< LAS: of byte 15, points that are left out; 0: none are.
};

}  // namespace relievo
