// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/grid.h"

namespace relievo {

// What this program has GDAL write, without GDAL's headers: whoever includes this needs no GDAL
// until the first of these functions is called (docs/adr/0178-gdal-when-it-is-called.md).

/// Names and texts kept with a raster, in the order in which they are written.
using RasterEntries = std::vector<std::pair<std::string, std::string>>;

/// What is known of a raster before its cells.
struct RasterSpec {
  GridSize size;
  int bands = 1;
  bool is_float = true;                   ///< Cells are float32, else bytes.
  std::vector<const char*> options = {};  ///< How GDAL's driver makes the file: "COMPRESS=DEFLATE".
  /// Of the corner of the highest row's first cell: x, dx, 0, y, 0, dy.
  std::array<double, 6> transform{0, 1, 0, 0, 0, -1};
  std::string projection = {};  ///< Well-known text; empty: none is stated.
  std::string unit = {};        ///< Of band 1; empty: none is stated.
  RasterEntries entries = {};   ///< Empty: none, or set later.
  bool nan_is_nodata = false;
  /// Tiles go through GDAL once, and none is read again: it keeps few of them.
  bool passes_once = false;
};

/// A raster that is being written. Rows are counted from the top, as in the file. What GDAL
/// complains about is kept instead of printed, and nothing more is written then. [one thread at a
/// time]
class RasterFile {
 public:
  static constexpr int kMask = 0;  ///< Instead of a band: 255 where the cell counts, else 0.

  RasterFile() = default;
  virtual ~RasterFile() = default;
  RasterFile(const RasterFile&) = delete;
  RasterFile& operator=(const RasterFile&) = delete;

  virtual void setEntries(const RasterEntries& entries) = 0;
  /// @param band   from 1, or kMask after `addMask`
  /// @param first  the first of `rows` rows @param cells  theirs, row-major, the highest row first
  /// @param step   bytes from one row to the one below it
  virtual void writeRows(int band, int first, int rows, const void* cells, std::ptrdiff_t step) = 0;
  /// The same of all bands, byte beside byte. @param pixels  rows x cols x bands
  virtual void writePixels(int first, int rows, const void* pixels) = 0;
  /// One tile of a file that is made of tiles. @param cells  as many as tiles are large
  virtual void writeTile(int band, int col, int row, const void* cells) = 0;
  /// Within the file, not beside it.
  virtual void addMask() = 0;
  /// A copy as a cloud-optimised GeoTIFF. @param goes_on  told the share done; false stops it
  virtual void copyForClouds(const std::filesystem::path& file,
                             const std::vector<const char*>& options,
                             const std::function<bool(double)>& goes_on) = 0;
  /// What is left goes to the file; a full disk shows itself here at the latest. To be asked `good`
  /// after it. Nothing else is called then.
  virtual void close() = 0;

  bool good() const noexcept { return good_; }
  const std::string& complaint() const noexcept { return complaint_; }  ///< GDAL's first, or empty.

 protected:
  bool good_ = true;
  std::string complaint_;
};

/// @param file  what is made, a GeoTIFF; empty: in memory
/// @return  `good` or not, never null. [any thread]
std::unique_ptr<RasterFile> createRasterFile(const std::filesystem::path& file,
                                             const RasterSpec& spec);

/// What the registry that PROJ has installed says of a coordinate system.
struct SystemFacts {
  bool is_geographic = false;  ///< x and y are degrees.
  double metres = 1;           ///< One unit of x and y.
};
/// @param epsg  its number @return  nothing if it is not known. [any thread]
std::optional<SystemFacts> systemFacts(int epsg);

/// A coordinate system that a file states, as what rasters have.
struct StatedSystem {
  std::string text;           ///< Well-known text.
  SystemFacts facts;          ///< Of x and y.
  bool left_heights = false;  ///< Its heights are in another unit than x and y: not in the text.
};
/// @param stated  well-known text, "EPSG:n" or "EPSG:n+v" (v: of the heights), as
///                ScanInfo::reference_system has it @return  nothing if it is none [any thread]
std::optional<StatedSystem> statedSystem(const std::string& stated);

/// Of the GDAL that this process uses: "3.6.2". [any thread]
std::string gdalVersion();

/// Gets ready what writes rasters, which takes as long as reading some 100 000 points: for whoever
/// will write one and waits for something else first. [any thread]
void prepareRasterFiles();

}  // namespace relievo
