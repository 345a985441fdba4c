// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/base/exchange.h"
#include "core/base/origin.h"
#include "core/base/task.h"
#include "core/io/import.h"
#include "core/session/surface.h"
#include "core/tiles/job/job_folder.h"

namespace relievo {

struct LargeMap;

/// How far a map by tiles is while its heights are made, to be looked at.
struct ReadyMap {
  DepthMap map;    ///< Every n-th cell, above the lowest place; what is not ready is from a sample.
  GridSize whole;  ///< Of the finest level.
  int rows = 0;    ///< Of it that are ready, from the lowest on.
};

struct LargeMapOptions {
  std::filesystem::path file;                  ///< Of the finest level; the others lie beside it.
  std::uint64_t memory_bytes = 2'000'000'000;  ///< For all but the program itself.
  int threads = 0;                             ///< 0: as many as there are usable cores.
  /// Called with surfaces made from a sample of the points: first after a fraction of a second from
  /// some 250 000, then from some 2 000 000 found while the whole is measured. Each covers the
  /// object as `LargeMap` will, but for points not seen yet. For rasters never. [worker]
  std::function<void(const Surface& view)> on_view;
  /// Called while the heights of a cloud's map are made, before gaps are filled, if there is
  /// `on_view`; at most every `ready_every_s`, and at their end. [worker]
  std::function<void(const ReadyMap& ready)> on_ready = {};
  double ready_every_s = 1;
  /// What every level's file says inside of where it comes from (ASCII); asked once, when all but
  /// the files is there. Null: nothing. [worker]
  std::function<std::string(const LargeMap& map)> state = {};
  /// Where what is finished of a map is kept, for who makes the same map after this process was
  /// stopped; no folder: nowhere. When the map is made the folder goes.
  struct Job {
    std::filesystem::path folder = {};
    JobFacts facts = {};                                  ///< Those of the same map are the same.
    std::uint64_t part_points = std::uint64_t{1} << 19U;  ///< Read and kept together.
  } job = {};
  /// That make the map together, each by this function with the same options; the first writes it.
  /// Null: this one alone. @pre several: a folder of the job that all of them see
  Exchange* processes = nullptr;
};

/// What an earlier process had finished.
struct TakenOver {
  std::uint64_t points = 0, parts = 0;  ///< Sorted into tiles, and in how many files.
  int rows = 0;                         ///< Of tiles that had their heights.
  int filled = 0;                       ///< Of these rows, whose gaps were filled, too.
  int damaged = 0;                      ///< Files that were not whole and were made anew.
};

/// A map made by tiles and what is known of it; its heights are in files only (TiledMap).
struct LargeMap {
  std::filesystem::path file;
  ScanInfo info;
  LengthUnit unit = LengthUnit::mm;
  UnitSource unit_source = UnitSource::assumed;
  ViewFromFile view_from_file;
  std::string view_name, engine, rule;
  bool has_colours = false, has_intensities = false;  ///< Are they in files beside it?
  std::vector<GridFrame> frames;                      ///< Per level, finest first.
  std::array<double, kOriginCount> shares{};          ///< Of the finest level's cells, by origin.
  HeightRange heights;                                ///< Over cells that are not outside.
  std::vector<Hole> holes;                            ///< Enclosed holes, largest first.
  std::optional<DepthLosses> losses;  ///< Of points that were not merged as they came.
  Strays strays;                      ///< Of clouds.
  std::uint64_t missing = 0;          ///< Points or cells left out as none, as of a Surface.
  std::vector<Message> messages;
  std::vector<Message> not_done;  ///< Steps that were asked for.
  StageSeconds seconds;
  double first_view_s = 0;  ///< From the call to the first on_view; 0: none.
  std::uint64_t spilled_bytes = 0;
  std::optional<TakenOver> taken_over;  ///< If there was a folder for it.
};

/// Makes the map of LAS, LAZ or binary PLY clouds, which are one scan in several files, or of one
/// raster by tiles, within a memory budget, and writes all levels (core/tiles/level_files.h): grid,
/// rule, holes, base plane and levels as makeSurface chooses them, for any budget the same bytes.
/// Of several processes each returns what it knows when all are done; only the first's map names
/// files, shares and messages in full. [worker]
/// @param inputs  in the order in which their points are counted (filesNamed); at least one
/// @throw FileError  also for meshes and files that cannot be read in blocks; OtherProcessStopped
/// @throw ArgumentError  E102 if the budget is too small for this map; WriteError, Cancelled
LargeMap makeLargeMap(const std::vector<std::filesystem::path>& inputs,
                      const SurfaceOptions& options, const LargeMapOptions& large,
                      const ImportOptions& import = {}, const Task& task = {});
LargeMap makeLargeMap(const std::filesystem::path& file, const SurfaceOptions& options,
                      const LargeMapOptions& large, const ImportOptions& import = {},
                      const Task& task = {});

/// A surface from about `points` of the file's points, spread evenly over it: the first view of a
/// large file. [worker] @throw FileError, ArgumentError, Cancelled
Surface sampleSurface(const std::filesystem::path& file, const SurfaceOptions& options,
                      std::uint64_t points, const ImportOptions& import = {},
                      const Task& task = {});

}  // namespace relievo
