// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/io/import.h"
#include "core/region/window.h"
#include "core/session/surface.h"

namespace CLI {  // NOLINT(readability-identifier-naming): the library's name.
class App;
}

namespace relievo::batch {

/// What of a scan is read, and how; the same for every verb that reads scans.
struct ScanArguments {
  bool accept_incomplete = false;
  bool keep_withheld = false;
  std::string parts;  ///< "1,3"; empty: all scans of the file.
  std::string reader = "auto";
  int every = 1;  ///< One point in so many.
};
void addScanOptions(CLI::App& verb, ScanArguments& arguments);
/// @throw ArgumentError  a value that is not of its option's form
ImportOptions importOptions(const ScanArguments& arguments);

/// Options of every verb that needs a surface; the same as the window's.
struct MapArguments {
  std::string file;
  std::string unit;  ///< Empty: as the file says.
  std::string view;  ///< Empty: default.
  std::string turn;  ///< "X,Y,Z" in degrees; empty: not turned.
  std::optional<int> cells;
  std::optional<double> spacing_mm;
  std::string engine = "cpu";
  std::string rule;  ///< Empty: from the data.
  std::string holes = "base";
  std::string strays = "drop";
  std::string nodata;  ///< Empty: as the file says; "none" or a height.
  std::optional<double> pixel_mm, height_mm, height_zero;  ///< Of a raster from elsewhere.
  double factor = 2;                                       ///< The paper's M.
  ScanArguments scan;
  bool as_recorded = false;  ///< Of a log: of what changed nothing nobody is told again.
};
void addMapOptions(CLI::App& verb, MapArguments& arguments);
/// @throw ArgumentError  a value that is not of its option's form
SurfaceOptions surfaceOptions(const MapArguments& arguments);

/// Which window of which level, and the height gain.
struct RegionArguments {
  std::optional<int> level;
  std::string region;  ///< "X,Y,W,H" in view mm; empty: the whole map.
  double gain = 1;
  bool gain_given = false;
  std::string window_out;    ///< Empty: not written.
  bool as_recorded = false;  ///< Of a log: it may lie beside the map.
};
void addRegionOptions(CLI::App& verb, RegionArguments& arguments);
/// @throw ArgumentError  also if it lies beside the map, and no log has it so
Region chosenRegion(const Surface& surface, const RegionArguments& arguments);

/// Exactly `count` comma-separated numbers. @throw ArgumentError naming the option
std::vector<double> numberList(const std::string& option, const std::string& text,
                               std::size_t count);

}  // namespace relievo::batch
