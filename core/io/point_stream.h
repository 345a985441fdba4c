// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>

#include "core/base/task.h"
#include "core/cloud/scan.h"
#include "core/io/import.h"
#include "core/io/owned_fd.h"
#include "core/io/scalar.h"

namespace relievo {

class UnpackedLas;

/// The points of a large file, block by block, without the file or the points in memory: LAS, and
/// binary PLY whose points have fixed places; LAZ and COPC while they are unpacked to the disk.
/// importScan reads the same points of the same files at once, and everything else.
class PointStream {
 public:
  /// Can these files' points be read in blocks? By content. @throw FileError  missing, empty ...
  static bool canStream(const std::filesystem::path& file);

  /// Is this a LAZ or COPC file, whose points are to be had only as fast as it is unpacked?
  /// @throw FileError  missing, empty ...
  static bool isPacked(const std::filesystem::path& file);

  /// Reads the header only; starts an installed program that unpacks LAZ and COPC to where TMPDIR
  /// says, until this object ends (core/io/unpack_las.h). Of `options` max_points does not apply.
  /// [worker]
  /// @param task  also stops what `read` waits for
  /// @throw FileError  malformed, or incomplete (E101) unless accepted; Cancelled
  explicit PointStream(const std::filesystem::path& file, const ImportOptions& options = {},
                       const Task& task = {});

  /// What the header says. `points` are those that can be read; `finite_points` and `bounds` are
  /// not known before they are, and stay empty.
  const ScanInfo& info() const noexcept { return info_; }

  /// The box that a LAS header states, not checked against the points; PLY states none.
  const std::optional<FileBounds>& statedBounds() const noexcept { return stated_bounds_; }

  /// Reads up to block.size() points from the `first` on, file coordinates. A point that importScan
  /// would leave out (not finite, beyond 1e38, or of LAS withheld) is three NaN, so that numbers
  /// stay those of the file. The same for every size of block. Allocates at most 1 MB. Of LAZ and
  /// COPC, waits until these points are unpacked. [any thread]
  /// @return  points read; fewer than asked for only at the end
  /// @throw FileError  the file became shorter, its disk failed, or it cannot be unpacked
  /// @throw Cancelled  by the task it was opened with, while it waits
  std::size_t read(std::uint64_t first, std::span<FilePoint> block) const;

 private:
  struct Coordinate {
    std::size_t offset = 0;  ///< In the record.
    ScalarType type = ScalarType::i32;
    double scale = 1, shift = 0;
  };

  void openLas(const std::filesystem::path& las, const ImportOptions& options);
  void openPacked(const ImportOptions& options, const Task& task);
  void openPly(const ImportOptions& options);
  void setFound(std::uint64_t promised, const ImportOptions& options);
  void readBytes(std::uint64_t at, std::span<char> bytes) const;
  FilePoint pointOf(const char* record) const noexcept;

  ScanInfo info_;
  std::optional<FileBounds> stated_bounds_;
  std::shared_ptr<UnpackedLas> unpacked_;  ///< Of LAZ and COPC.
  OwnedFd fd_;
  std::uint64_t file_bytes_ = 0;
  std::uint64_t points_at_ = 0;
  std::size_t record_bytes_ = 1;
  ByteOrder order_ = ByteOrder::little;
  std::array<Coordinate, 3> coordinates_;
  std::uint8_t withheld_bit_ = 0;  ///< LAS: of byte 15, points that are left out; 0: none are.
};

}  // namespace relievo
