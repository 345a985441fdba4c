// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/task.h"
#include "core/base/transform.h"
#include "core/depth/colours/colours.h"
#include "core/io/web/published_map.h"
#include "core/message/message.h"
#include "core/region/region.h"
#include "core/region/window.h"

namespace relievo {

/// For the tiles of a map that are in memory, unless somebody says otherwise.
inline constexpr std::size_t kTileCacheBytes = std::size_t{64} << 20U;

/// A tile of a map, counted from the top left.
struct TileName {
  int level = 0;
  TilePart part = TilePart::heights;
  int number = 0;
  friend auto operator<=>(const TileName&, const TileName&) = default;
};

/// A map whose levels lie in files (core/tiles/level_files.h), or that was published
/// (core/tiles/published), and of which only the tiles under recent windows are in memory.
/// Immutable but for that cache; safe from every thread.
class TiledMap {
 public:
  /// Does this file say it is the finest level of a tiled map? False for all other files.
  static bool isOne(const std::filesystem::path& file);

  /// Opens all levels; reads no tile, but of maps from the web the coarsest levels, which stay in
  /// memory: up to 64 tiles of 320 kB, and the colours of those up to 1024 cells across.
  /// @param finest  or map.json of a published map
  /// @param cache_bytes  for tiles; a window touches up to nine of 256 KiB and nine of 64 KiB
  /// @throw FileError  a level is missing, belongs to another map, or was rewritten; WebLost;
  ///                   Cancelled
  explicit TiledMap(const std::filesystem::path& finest, std::size_t cache_bytes = kTileCacheBytes,
                    const Task& task = {});
  ~TiledMap();
  TiledMap(const TiledMap&) = delete;
  TiledMap& operator=(const TiledMap&) = delete;

  const std::filesystem::path& file() const noexcept;
  /// What lies beside it and belongs to it: origins, coarser levels and theirs.
  std::vector<std::filesystem::path> otherFiles() const;
  const std::vector<GridFrame>& frames() const noexcept;  ///< Per level, finest first.
  const ViewFromFile& viewFromFile() const noexcept;
  const DetailLadder& ladder() const noexcept;
  HeightRange heights() const noexcept;  ///< Of the finest level, as heightRange.
  const std::array<double, kOriginCount>& shares() const noexcept;  ///< As originShares.

  /// What sampleWindow gives for the same map in memory, bit for bit; but the origins at a coarse
  /// level are those of its nodes, because the map's own would touch every tile. Takes what is not
  /// in the cache from the files and keeps it there. [any thread]
  /// @throw ArgumentError  as sampleWindow. FileError  a file was damaged or cut meanwhile
  RegionWindow window(const Region& region, double gain = 1) const;

  /// A rectangle of a level's nodes as a map of its own: heights as a window has them, origins of
  /// the finest cells nearest to the nodes. Reads the tiles under it, one row of tiles at a time.
  /// [any thread] @pre it lies within the level @throw FileError
  DepthMap part(Level level, Cell first, GridSize size) const;
  /// A whole level. [any thread] @pre level exists @throw FileError
  DepthMap levelMap(Level level) const;

  /// Has the map colours, or intensities, in files beside it? Files of another map do not count.
  bool hasColours() const noexcept;
  bool hasIntensities() const noexcept;
  /// Why not, if there are such files but they belong to another map; else nothing.
  const std::optional<Message>& coloursLeftAside() const noexcept;

  /// What windowColours gives for the same map in memory, bit for bit. [any thread]
  /// @param window  of this map @throw FileError
  GridColours windowColours(const RegionWindow& window, int ring = 0) const;
  /// Of the nodes of `part`, holes too. [any thread] @pre it lies within the level @throw FileError
  GridColours partColours(Level level, Cell first, GridSize size) const;

  /// Loads the tiles that a window of this region needs. [any thread] @throw FileError
  void prefetch(const Region& region) const;

  /// Tiles read from files since opening.
  std::size_t tilesRead() const noexcept;

  /// What makes the map this one, and the state that its files carry; empty: they say none.
  const std::string& set() const noexcept;
  const std::string& state() const noexcept;
  /// Does a tile that is not in memory come from the web? Whoever must not wait asks `atHand`.
  bool isRemote() const noexcept;
  /// Of a published map, in words for people; else null.
  const PublishedMap* published() const noexcept;
  const std::string& place() const noexcept;  ///< Its address or folder; else the file.

  /// As they are in files, but heights outside the object are 0. Waits for it.
  /// [any thread but the haptic loop] @throw FileError, WebLost, Cancelled
  std::shared_ptr<const std::vector<std::byte>> tile(Level level, TilePart part, int number,
                                                     const Task& task = {}) const;
  bool isAtHand(const TileName& tile) const;
  /// The tiles that a window needs; none if there is no such level. Heights and origins come first.
  std::vector<TileName> tilesUnder(const Region& region) const;
  /// The finest level, from the region's on, of which all tiles under it are in memory: heights and
  /// origins. Nothing: no level's are. Reads nothing. [any thread but the haptic loop]
  std::optional<Level> levelAtHand(const Region& region) const;
  /// Are the colours of a window of this region in memory? True of a map without colours.
  /// [any thread but the haptic loop]
  bool coloursAtHand(const Region& region) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// One worker thread that loads the tiles around the newest window before they are needed: a
/// quarter of a window to each side, and the same place one level finer and one coarser.
class TilePrefetcher {
 public:
  explicit TilePrefetcher(std::shared_ptr<const TiledMap> map);
  ~TilePrefetcher();
  TilePrefetcher(const TilePrefetcher&) = delete;
  TilePrefetcher& operator=(const TilePrefetcher&) = delete;

  /// The window that is shown now; what was asked for before is dropped. Does not wait. [owner]
  void around(const Region& region);
  /// Waits until nothing is left to load. What a file refuses is left for `window` to say. [owner]
  void wait();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace relievo
