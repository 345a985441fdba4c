// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/base/grid.h"
#include "core/depth/colours/colours.h"
#include "core/file/output_set.h"
#include "core/pyramid/pyramid.h"
#include "core/tiles/colours/colour_rows.h"

namespace relievo {

/// Colours and intensities of a tiled map on disk: beside each level's file one of red, green, blue
/// and alpha and one of grey and alpha, in the tiles of its heights, not compressed: pictures in
/// every program that reads GeoTIFF, of which single tiles can be read (docs/adr/0108).
class ColourFiles {
 public:
  /// @param finest  file of level 0, @param frames  of all levels
  /// @throw WriteError  also if a file of anybody else has one of the names
  ColourFiles(const std::filesystem::path& finest, std::vector<GridFrame> frames, double factor,
              bool colours, bool intensities);
  ~ColourFiles();
  ColourFiles(const ColourFiles&) = delete;
  ColourFiles& operator=(const ColourFiles&) = delete;

  /// The map's next row, lowest first; null for what there is not. [worker] @throw WriteError
  void add(const Rgba* colours, const GreyAlpha* intensities);

  bool hasColours() const noexcept { return colours_; }
  bool hasIntensities() const noexcept { return intensities_; }

  /// After the last row: all files are written, with what they belong to.
  /// @param set  of the heights (LevelFiles): whose colours these are
  void finish(const std::string& set);

  /// After `finish`: all files, on the disk and not yet in their places.
  OutputSet& files() noexcept { return files_; }

  /// To be asked before the work: are the names beside a level free, or of ours?
  /// @throw WriteError
  static void requireFree(const std::filesystem::path& level);
  /// What an older map of ours left beside a level's file goes with the set.
  static void removeStale(const std::filesystem::path& level, bool colours, bool intensities,
                          OutputSet& set);

 private:
  struct Level;
  void take(const ColourRow& row);

  OutputSet files_;
  bool colours_, intensities_;
  std::vector<std::unique_ptr<Level>> levels_;
  ColourPyramidRows pyramid_;
};

}  // namespace relievo
