// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "core/session/large/large_colours.h"
#include "core/session/large/large_map.h"
#include "core/session/large/large_memory.h"
#include "core/tiles/colours/band_colours.h"
#include "core/tiles/colours/colour_files.h"

namespace relievo {

/// Where a map by tiles keeps what does not fit into memory: beside its files.
std::filesystem::path spillFolder(const LargeMapOptions& large);

/// Notes what the points say beside their places, or that there is no room for it.
/// @return  are there any, and room for them?
bool takeValues(LargeMap& map, const StreamedValues& values, const MemoryPlan& plan);

/// To be asked before the work. @throw WriteError  a file of somebody else has the name of one that
/// colours would get
void requireFreeNames(const std::vector<GridFrame>& frames, const std::filesystem::path& finest);

/// Are there colours or intensities of ours beside a map?
bool hasOwnColours(const std::filesystem::path& map_file);

/// Colours of a cloud's map by tiles while its rows are made.
class CloudColours {
 public:
  /// Reads all points again. [worker]
  /// @param map     with the finished map's view, and its rule
  /// @param values  must stay @param keeps  which points take part; null: all
  /// @throw Cancelled, FileError, WriteError
  CloudColours(const LargeMap& map, const GridFrame& frame, const StreamedValues& values,
               const std::function<bool(const FilePoint&)>& keeps, const LargeMapOptions& large,
               std::size_t memory_bytes, const Task& task);

  /// As BandColours::add.
  void add(const float* heights_mm, const CellStatus* origins, const Task& task) {
    colours_.add(heights_mm, origins, task);
  }

  /// After the last row: writes the files of all levels, and notes in `map` that they are there.
  /// @param map  with its frames @return  null if no cell has one @throw Cancelled, WriteError
  std::unique_ptr<ColourFiles> write(LargeMap& map, double factor, const Task& task);

 private:
  const StreamedValues& values_;
  std::filesystem::path file_;
  ValueStore store_;
  BandColours colours_;
};

}  // namespace relievo
