// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

#include "core/base/task.h"
#include "core/cloud/scan.h"

namespace relievo {

/// Whose code reads the points: PCL's wherever it reads them right, PCL's or else nothing, or that
/// of this program.
enum class ReaderChoice : std::uint8_t { automatic, pcl, own };
inline constexpr std::array<std::string_view, 3> kReaderNames{"auto", "pcl", "own"};

/// What of a scan is read, and by whom. Kept with every result made from it.
struct ScanChoices {
  bool keep_withheld = false;  ///< LAS: take points that are marked as not to be used.
  ReaderChoice reader = ReaderChoice::automatic;
  std::vector<int> parts = {};  ///< E57, PTX: which scans of the file, from 1; empty: all.
  std::uint64_t every = 1;      ///< Of clouds: one point in so many, the first of each; >= 1.
  friend bool operator==(const ScanChoices&, const ScanChoices&) = default;
};

struct ImportOptions {
  bool accept_incomplete = false;  ///< E101: load the complete records of a cut file.
  ScanChoices scan = {};
  std::uint64_t max_points = 200'000'000;
  std::uint64_t max_memory_bytes = 6ULL << 30;  ///< Address space of the import worker.
  double max_cpu_s = 600;
  /// Memory that can be had, if it is known: files whose header promises more points than that
  /// holds are refused before the first is read (E102).
  std::optional<std::uint64_t> free_bytes = std::nullopt;
};

/// Reads a scan of any format that scanFormatList() names (core/io/format.h), chosen by content
/// first, name second.
/// Header and sizes are checked here; the file is then read in a child process (relievo-import,
/// installed with the program) with limits, in the C locale; the result is checked again. Acts on a
/// stop request within 250 ms. [worker]
/// @throw FileError  missing, a directory, empty, malformed, incomplete (E101), unknown format, or
///                   no finite point, more than the memory holds (E102); the message names file,
///                   finding and remedy
/// @throw ArgumentError  PCL was asked for where it reads wrong, a part that is not there, or one
///                       point in several of a mesh
/// @throw Cancelled
Scan importScan(const std::filesystem::path& file, const ImportOptions& options = {},
                const Task& task = {});

struct RasterMap;  // core/io/raster/raster.h

/// Reads a height raster (TIFF, PNG, ESRI ASCII grid) as readRaster does, in a child process like
/// importScan. Of `options` the limits apply. [worker]
/// @throw FileError, Cancelled
RasterMap importRaster(const std::filesystem::path& file, const ImportOptions& options = {},
                       const Task& task = {});

}  // namespace relievo
