// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/base/task.h"
#include "core/io/web/published_map.h"
#include "core/io/web/web_link.h"
#include "core/tiles/published/kept_tiles.h"

namespace relievo {

/// The server gives no answer now; it may the next time.
struct WebLost : FileError {
  using FileError::FileError;
};

/// The tiles of a published map (core/io/web/published_map.h), of a folder or of the web; each is
/// compared with its checksum before anybody has it. Tiles from the web are kept in a folder.
/// [any thread but the haptic loop]
class PublishedTiles {
 public:
  /// @param manifest  map.json of a published folder, or as webMap made it
  /// @throw FileError  it is none, or what belongs to it is damaged; WebLost
  explicit PublishedTiles(const std::filesystem::path& manifest);

  const PublishedMap& map() const noexcept { return map_; }
  bool isRemote() const noexcept { return kept_ != nullptr; }
  /// The address, or the folder.
  const std::string& place() const noexcept { return place_; }
  /// Of a folder: what belongs to the map beside map.json.
  std::vector<std::filesystem::path> files() const;

  /// Waits for what has to be fetched. Of a tile that is not there the cells are outside.
  /// @throw FileError  it is not what was published; WebLost, Cancelled
  std::vector<std::byte> read(int level, TilePart part, int tile, const Task& task = {}) const;

  /// Tiles that came over the link so far.
  std::size_t fetched() const noexcept { return fetched_; }

 private:
  using Records = std::shared_ptr<const std::vector<TileRecord>>;
  std::vector<std::byte> fetch(WebAsk what, const std::string& file, std::uint64_t first,
                               std::uint32_t count, const Task& task,
                               TilePart part = TilePart::heights) const;
  void readPackList();
  const PackRecord* packOf(int level, int pack) const;
  Records recordsOf(const PackRecord& pack, const Task& task) const;

  std::filesystem::path manifest_;
  std::string place_;
  PublishedMap map_;
  std::vector<PackRecord> packs_;
  std::unique_ptr<KeptTiles> kept_;  ///< Of the web.
  mutable WebLink link_;
  mutable std::mutex mutex_;
  mutable std::map<std::pair<std::uint32_t, std::uint32_t>, Records> records_;
  mutable std::atomic<std::size_t> fetched_ = 0;
};

/// What an address stands for on this computer.
struct WebMap {
  std::filesystem::path manifest;  ///< For TiledMap and all that asks for a file.
  bool from_before = false;        ///< The server gives no answer; it was opened earlier.
};
/// Looks at the address and keeps its map.json. [worker]
/// @param address  of the folder or of its map.json
/// @throw FileError  there is no published map; WebLost; Cancelled
WebMap webMap(const std::string& address, const Task& task = {});

/// The same without asking anybody: as it was opened last. Nothing: it was not.
std::optional<std::filesystem::path> keptMap(const std::string& address);

/// Of a map.json that webMap keeps. Empty for all others: a folder of somebody's must not send this
/// program to a server.
std::string addressOfKeptMap(const std::filesystem::path& manifest);

Checksum checksumOf(std::span<const std::byte> bytes);

}  // namespace relievo
