// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "core/base/task.h"
#include "core/file/owned_fd.h"
#include "core/io/import.h"
#include "core/io/raster/raster.h"

namespace relievo {

/// A raster that the import worker left in a file without a name: any number of rows at a time,
/// none of it in memory otherwise.
class RasterRows {
 public:
  /// What receiveAnswer found. @param heights_at, origins_at  places in the file
  RasterRows(RasterHead head, OwnedFd file, std::uint64_t heights_at,
             std::optional<std::uint64_t> origins_at);

  const RasterHead& head() const noexcept { return head_; }
  bool hasOrigins() const noexcept { return origins_at_.has_value(); }

  /// Names the file that was read, for messages.
  void nameFile(const std::filesystem::path& file) { head_.info.file = file; }

  /// Rows from `first_row` on, row 0 at the lowest y; NaN where there is no height. `origins` may
  /// be null; it is left alone if there are none. [any thread]
  /// @throw FileError  what the worker left makes no sense
  void read(int first_row, int rows, float* heights, CellStatus* origins) const;

 private:
  RasterHead head_;
  OwnedFd file_;
  std::uint64_t heights_at_ = 0;
  std::optional<std::uint64_t> origins_at_;
};

/// importRaster for rasters that need not fit into memory. [worker]
/// @param folder  where the heights are kept meanwhile: 4 bytes a cell, 5 for own maps
/// @throw FileError, Cancelled
RasterRows importRasterRows(const std::filesystem::path& file, const std::filesystem::path& folder,
                            const ImportOptions& options = {}, const Task& task = {});

}  // namespace relievo
