// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/base/task.h"
#include "core/io/web/published_map.h"

namespace relievo {

class TiledMap;  // core/tiles/tiled_map.h

/// What people say of a map that they publish.
struct PublishWords {
  std::string title, licence, citation;
};

struct Published {
  std::uint64_t tiles = 0, outside_tiles = 0, packs = 0;
  std::uint64_t bytes = 0, bytes_of_tiles = 0;  ///< In the folder; of the tiles as they are read.
  std::string sha256;                           ///< Of map.json: the map's identity.
};

/// Makes the folder of a published map, pack by pack; it takes its place whole, at the end.
class PublishedFolder {
 public:
  /// @param folder  absent or empty @param map  without its list of packs
  /// @throw WriteError  there is something in the folder, or it cannot be written
  PublishedFolder(const std::filesystem::path& folder, PublishedMap map);
  ~PublishedFolder();
  PublishedFolder(const PublishedFolder&) = delete;
  PublishedFolder& operator=(const PublishedFolder&) = delete;

  /// The tiles of a pack, made by several threads. Packs come ordered by level and number; those
  /// that are left out, and those of whose tiles none is inside, are outside.
  /// @param tile  gives one of the level's; the cells of the parts in their order, empty: outside
  /// @throw WriteError; what `tile` throws; Cancelled
  using TileOf = std::function<std::vector<std::vector<std::byte>>(int tile)>;
  void add(int level, int pack, const TileOf& tile, const Task& task = {});

  /// @throw WriteError
  Published finish();

 private:
  void write(const std::string& name, std::string_view bytes);

  std::filesystem::path folder_, made_in_;
  PublishedMap map_;
  std::vector<PackRecord> packs_;
  Published done_;
};

/// Publishes a map by tiles: its levels, and its colours if it has any. Lossless. [worker]
/// @throw FileError  a tile cannot be read; WriteError; Cancelled
Published publish(const TiledMap& map, const std::filesystem::path& folder,
                  const PublishWords& words, const Task& task = {});

/// Packs of a level, and the tiles of one of them.
int packsOf(GridSize size) noexcept;
std::vector<int> tilesOfPack(GridSize size, int pack);

}  // namespace relievo
