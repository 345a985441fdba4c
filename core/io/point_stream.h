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
#include "core/io/formats/scalar.h"
#include "core/io/import.h"
#include "core/io/las/las_unit.h"
#include "core/io/las/laz_points.h"

namespace relievo {

/// What a file stores of a point beside its place, in the numbers it stores (point_values.h).
struct StoredValues {
  std::array<float, 3> colour{};  ///< Red, green, blue.
  float intensity = 0;
};

/// What of the points a stream gives. Packed files unpack no more than that.
enum class StreamedParts { places, values };

/// What is known of a stream before its points are.
struct PointStreamHead {
  ScanInfo info;
  std::optional<FileBounds> stated_bounds;
  std::optional<ScalarType> colour_type, intensity_type;
  bool word_intensities = false, is_packed = false;
  std::string colour_source;
  std::uint64_t kept_bytes = 0;
  std::optional<LasSystem> system;           ///< Its unit is still to be looked up; what is said of
  std::uint64_t warnings_before_system = 0;  ///< it comes behind so many of `info`.
};

/// The points of a large file, block by block, without the file or the points in memory: LAS, LAZ
/// and COPC, and binary PLY whose points have fixed places. An import process reads them for as
/// long as the stream lives; the thread that made it must live as long.
/// importScan reads the same points of the same files at once, and everything else.
class PointStream {
 public:
  /// Can these files' points be read in blocks? By content. @throw FileError  missing, empty ...
  static bool canStream(const std::filesystem::path& file);

  /// Reads the header only, and the list of chunks of LAZ and COPC. Of `options` the limits on
  /// points and processor time do not apply. [worker]
  /// @param task  also stops `read`
  /// @throw FileError  malformed, or incomplete (E101) unless accepted; LAZ that is cut
  explicit PointStream(const std::filesystem::path& file, const ImportOptions& options = {},
                       const Task& task = {}, StreamedParts parts = StreamedParts::places);
  ~PointStream();
  PointStream(const PointStream&) = delete;
  PointStream& operator=(const PointStream&) = delete;

  /// What the header says. `points` are those that can be read; `finite_points` and `bounds` are
  /// not known before they are, and stay empty.
  const ScanInfo& info() const noexcept;

  /// The box that a LAS header states, not checked against the points; PLY states none.
  const std::optional<FileBounds>& statedBounds() const noexcept;

  /// Reads up to block.size() points from the `first` on, file coordinates. A point that importScan
  /// would leave out (not finite, beyond 1e38, of LAS withheld) is three NaN: numbers stay those of
  /// the file. The same for every size of block. The process allocates at most 1 MB, of LAZ and
  /// COPC 32 MB (or one chunk) for each thread that reads, kept for its next block. [any thread]
  /// @return  points read; fewer than asked for only at the end
  /// @throw FileError  the file became shorter, its disk failed, or packed points are damaged
  /// @throw Cancelled  by the task it was opened with
  std::size_t read(std::uint64_t first, std::span<FilePoint> block) const;

  /// The same with what is stored beside the places; of what is not stored, 0. @pre made for values
  std::size_t read(std::uint64_t first, std::span<FilePoint> block,
                   std::span<StoredValues> values) const;

  /// The points of several ranges, one after the other. @pre they lie within the file, and the
  /// block is as long as all of them [any thread] @throw as read
  void read(std::span<const PointRange> ranges, std::span<FilePoint> block) const;

  /// Memory that every thread which reads keeps for its next block: of packed files. [any thread]
  std::size_t keptBytes() const noexcept;

  /// The numbers that the file has places for; they may all be 0. Nothing: there are none.
  std::optional<ScalarType> colourType() const noexcept;
  std::optional<ScalarType> intensityType() const noexcept;
  /// Formats whose intensities are 16 bits by their specification; only zeros mean none.
  bool hasWordIntensities() const noexcept;
  const std::string& colourSource() const noexcept;  ///< As ColourFact.

  /// About `points` points all over a packed file that cost the least to read: of COPC the coarsest
  /// levels, of LAZ the beginning of each chunk. Empty where all points cost the same.
  std::vector<PointRange> cheapSample(std::uint64_t points) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace relievo
