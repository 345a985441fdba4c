// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/error.h"
#include "core/io/web/published_map.h"
#include "core/message/message.h"
#include "core/tiles/map/tiled_facts.h"

namespace relievo {

/// Says why a file is not a readable part of a tiled map. @throw FileError  always
[[noreturn]] void refuseMap(const std::filesystem::path& file, Message why);

/// The tiles of a map whose levels lie in files beside each other (core/tiles/level_files.h).
/// Immutable; safe from every thread.
class MapFiles {
 public:
  /// Opens all levels and checks that they belong together; reads no tile.
  /// @throw FileError  a level is missing, belongs to another map, or was rewritten
  explicit MapFiles(const std::filesystem::path& finest);
  ~MapFiles();
  MapFiles(const MapFiles&) = delete;
  MapFiles& operator=(const MapFiles&) = delete;

  const TiledFacts& facts() const noexcept { return facts_; }
  /// Why colours beside the map are not used, because they belong to another map; else nothing.
  const std::optional<Message>& coloursLeftAside() const noexcept { return left_aside_; }
  bool has(TilePart part) const noexcept;
  /// What lies beside the finest level and belongs to it: origins, coarser levels and theirs.
  std::vector<std::filesystem::path> otherFiles() const;
  /// The file that a level's heights or origins lie in. @pre the level exists
  const std::filesystem::path& fileOf(int level, TilePart part) const noexcept;
  /// A tile with the bytes of the file; the bands of a pixel stand beside each other.
  /// @pre the map has the part, and the level the tile @throw FileError
  std::vector<std::byte> read(int level, TilePart part, int tile) const;

 private:
  struct LevelTiles;

  void openCoarser(const std::filesystem::path& finest, int count);
  void takeWhole(const std::filesystem::path& finest);
  void openColours();

  TiledFacts facts_;
  std::vector<std::unique_ptr<LevelTiles>> levels_;
  std::optional<Message> left_aside_;
};

}  // namespace relievo
