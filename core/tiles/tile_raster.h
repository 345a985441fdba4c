// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/grid.h"
#include "core/file/atomic_file.h"
#include "core/io/raster/tiff_head.h"
#include "core/tiles/row_store.h"

namespace relievo {

using RasterFacts = std::map<std::string, std::string>;  ///< Names and texts kept with a raster.

/// The fact that is the TIFF's image description.
inline constexpr const char* kStateFact = "TIFFTAG_IMAGEDESCRIPTION";

/// Writes a GeoTIFF of 256 x 256 tiles, not compressed, from rows that come lowest first, with no
/// more than one row of tiles in memory. The file is beside its place until `commit`.
class TileRasterWriter {
 public:
  struct Layout {
    std::size_t cell_bytes = 4;  ///< 4: float, nodata NaN if `nan_is_nodata`. 1: whole numbers.
    int bands = 1;
    bool nan_is_nodata = false;
    bool has_alpha = false;  ///< A picture: the last band is alpha, not multiplied in.
  };
  /// @throw WriteError
  TileRasterWriter(const OutputFile& file, const GridFrame& frame, const Layout& layout);
  ~TileRasterWriter();
  TileRasterWriter(const TileRasterWriter&) = delete;
  TileRasterWriter& operator=(const TileRasterWriter&) = delete;

  /// The next row of every band. @throw WriteError
  void add(std::span<const void* const> bands);
  /// After the last row. @param mask  valid cells, or null @throw WriteError
  void close(const RasterFacts& facts, const BitRows* mask);
  /// The closed file becomes a member of the set of its place, or takes its place.
  /// @throw WriteError
  void commit();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// A GeoTIFF as TileRasterWriter makes them, opened for reading single tiles. After opening, tiles
/// are read straight from their place in the file.
class TileRaster {
 public:
  /// @param head  importTiffHead of the file: nothing in it is parsed here
  /// @throw FileError  not such a file
  TileRaster(const std::filesystem::path& file, const std::optional<TiffHead>& head,
             std::size_t cell_bytes, int bands);
  ~TileRaster();
  TileRaster(const TileRaster&) = delete;
  TileRaster& operator=(const TileRaster&) = delete;

  GridSize size() const noexcept { return size_; }
  const RasterFacts& facts() const noexcept { return facts_; }
  std::size_t tileBytes() const noexcept;
  int tilesAcross() const noexcept;

  /// One tile of one band, its rows from the top as in the file; tiles are counted from the top
  /// left. [any thread] @throw FileError  the file became shorter
  void read(int band, int tile, std::span<std::byte> out) const;

 private:
  std::filesystem::path file_;
  GridSize size_;
  std::size_t cell_bytes_;
  RasterFacts facts_;
  std::vector<std::uint64_t> offsets_;  ///< Band by band.
  int fd_ = -1;
};

/// The facts of a GeoTIFF, empty if it is none or has none; an import process reads them. [any
/// thread]
RasterFacts rasterFacts(const std::filesystem::path& file);

}  // namespace relievo
