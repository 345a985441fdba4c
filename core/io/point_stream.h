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
#include "core/io/import.h"
#include "core/io/laz_points.h"
#include "core/io/point_columns.h"
#include "core/io/scalar.h"

namespace relievo {

/// What a file stores of a point beside its place, in the numbers it stores (point_values.h).
struct StoredValues {
  std::array<float, 3> colour{};  ///< Red, green, blue.
  float intensity = 0;
};

/// What of the points a stream gives. Packed files unpack no more than that.
enum class StreamedParts { places, values };

/// The points of a large file, block by block, without the file or the points in memory: LAS, LAZ
/// and COPC, and binary PLY whose points have fixed places.
/// importScan reads the same points of the same files at once, and everything else.
class PointStream {
 public:
  /// Can these files' points be read in blocks? By content. @throw FileError  missing, empty ...
  static bool canStream(const std::filesystem::path& file);

  /// Reads the header only, and the list of chunks of LAZ and COPC. Of `options` max_points does
  /// not apply. [worker]
  /// @param task  also stops `read` of LAZ and COPC
  /// @throw FileError  malformed, or incomplete (E101) unless accepted; LAZ that is cut
  explicit PointStream(const std::filesystem::path& file, const ImportOptions& options = {},
                       const Task& task = {}, StreamedParts parts = StreamedParts::places);

  /// What the header says. `points` are those that can be read; `finite_points` and `bounds` are
  /// not known before they are, and stay empty.
  const ScanInfo& info() const noexcept { return info_; }

  /// The box that a LAS header states, not checked against the points; PLY states none.
  const std::optional<FileBounds>& statedBounds() const noexcept { return stated_bounds_; }

  /// Reads up to block.size() points from the `first` on, file coordinates. A point that importScan
  /// would leave out (not finite, beyond 1e38, of LAS withheld) is three NaN: numbers stay those of
  /// the file. The same for every size of block. Allocates at most 1 MB, of LAZ and COPC 32 MB (or
  /// one chunk) for each thread that reads, kept for its next block. [any thread]
  /// @return  points read; fewer than asked for only at the end
  /// @throw FileError  the file became shorter, its disk failed, or packed points are damaged
  /// @throw Cancelled  by the task it was opened with (LAZ and COPC)
  std::size_t read(std::uint64_t first, std::span<FilePoint> block) const;

  /// Memory that every thread which reads keeps for its next block: of packed files. [any thread]
  std::size_t keptBytes() const noexcept { return packed_ ? packed_->keptBytes() : 0; }

  /// The numbers that the file has places for; they may all be 0. Nothing: there are none.
  std::optional<ScalarType> colourType() const noexcept;
  std::optional<ScalarType> intensityType() const noexcept;
  /// Formats whose intensities are 16 bits by their specification; only zeros mean none.
  bool hasWordIntensities() const noexcept { return word_intensities_; }
  const std::string& colourSource() const noexcept { return colour_source_; }  ///< As ColourFact.

  /// The same with what is stored beside the places; of what is not stored, 0. @pre made for values
  std::size_t read(std::uint64_t first, std::span<FilePoint> block,
                   std::span<StoredValues> values) const;

  /// About `points` points all over a packed file that cost the least to read: of COPC the coarsest
  /// levels, of LAZ the beginning of each chunk. Empty where all points cost the same.
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

  ScanInfo info_;
  std::optional<FileBounds> stated_bounds_;
  std::shared_ptr<const LazPoints> packed_;  ///< Of LAZ and COPC.
  std::shared_ptr<const OwnedFd> fd_;
  std::uint64_t file_bytes_ = 0;
  std::uint64_t points_at_ = 0;
  std::size_t record_bytes_ = 1;  ///< Those that are read.
  ByteOrder order_ = ByteOrder::little;
  std::array<Coordinate, 3> coordinates_;
  std::optional<std::array<StoredNumber, 3>> colour_;
  std::optional<StoredNumber> intensity_;
  bool word_intensities_ = false;
  std::string colour_source_;
  std::uint8_t withheld_bit_ = 0;  ///< LAS: of byte 15, points that are left out; 0: none are.
};

}  // namespace relievo
