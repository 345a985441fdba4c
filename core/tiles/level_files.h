// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "core/base/transform.h"
#include "core/file/output_set.h"
#include "core/pyramid/pyramid.h"
#include "core/tiles/pyramid_rows.h"

namespace relievo {

/// File of a level beside the finest: MAP.tif -> MAP.L1.tif, and MAP.L0.tif -> MAP.L1.tif.
std::filesystem::path levelFile(const std::filesystem::path& finest, int level);
/// MAP.tif -> MAP.origin.tif.
std::filesystem::path originFile(const std::filesystem::path& level);

/// Goes with the set: what an older pyramid of ours has beside the finest level from level `count`
/// on, which nobody would tell from levels of the new one.
void removeLevelsFrom(const std::filesystem::path& finest, int count, OutputSet& set);

class ColourFiles;  // core/tiles/colours/colour_files.h

/// A tiled map on disk: per level one GeoTIFF of raw 256 x 256 float tiles and, beside it, one of
/// origins (band 1) and of the share of measured cells in 1/255 (band 2). Each file says where its
/// own nodes lie (cell centres at first + i M^l dx, exactly), so that every program that reads
/// GeoTIFF sees every level in its place; overviews inside one file could not, because a GeoTIFF's
/// overviews cover the same rectangle as the whole, which shifts the nodes. Each also says the
/// finest level's height range and how many of its cells are of which origin. Cells outside the
/// object are NaN in the finest level and masked in the others. docs/adr/0037.
class LevelFiles {
 public:
  /// @param finest  file of level 0
  /// @throw WriteError  also if a level or its origins would replace a file that is not ours;
  ///                    ArgumentError
  LevelFiles(const std::filesystem::path& finest, const GridFrame& map,
             const PyramidOptions& options);
  ~LevelFiles();
  LevelFiles(const LevelFiles&) = delete;
  LevelFiles& operator=(const LevelFiles&) = delete;

  /// The map's next row, lowest first, as in DepthMap. [worker] @throw WriteError
  void add(const float* heights_mm, const CellStatus* origins);

  /// After the last row: all files take their places, once all are on the disk; before, what was
  /// there is as it was. Levels of an older map of ours that go further are removed.
  /// @param state  becomes every file's image description, as MapFileOptions::state; empty: none
  /// @throw WriteError
  /// @param colours  of the same map, all its rows added; null: it has none, and those of an older
  ///                 map of ours go
  void finish(const ViewFromFile& view_from_file, const std::string& state = {},
              ColourFiles* colours = nullptr);

  const std::vector<GridFrame>& frames() const noexcept { return frames_; }

 private:
  struct Level;
  void take(const LevelRow& row);
  void takeFinest(float height_mm, CellStatus origin);
  std::string setOf(const ViewFromFile& view_from_file, const std::string& state) const;

  std::filesystem::path finest_;
  PyramidOptions options_;
  std::vector<GridFrame> frames_;
  OutputSet files_;
  std::vector<std::unique_ptr<Level>> levels_;
  PyramidRows pyramid_;
  std::uint64_t content_ = 0;  ///< Of level 0.
  // What the files say of level 0, as heightRange and originCounts.
  float low_mm_ = std::numeric_limits<float>::infinity(), high_mm_ = -low_mm_;
  OriginCounts counts_{};
};

}  // namespace relievo
