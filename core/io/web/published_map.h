// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/grid.h"
#include "core/base/origin.h"

namespace relievo {

/// What a tile of a map holds; a published map has the first two, and the others or not.
enum class TilePart : std::uint8_t { heights, origins, colours, intensities };
inline constexpr std::size_t kTileParts = 4;
/// Bytes of a tile of 256 x 256 cells.
std::size_t bytesOf(TilePart part) noexcept;

// A published map is a folder: map.json, packs.bin, and L<level>.p<number>.tiles, each with up to
// 16 x 16 tiles, counted as tiles are, row by row from the top left. A pack begins with a record
// for each of its tiles and parts; packs.bin has the checksum of these records of each pack, and
// map.json that of packs.bin. So whoever knows the checksum of map.json knows every tile's. What a
// pack does not hold is outside the object. docs/adr/0199.

inline constexpr const char* kPublishedName = "map.json";
inline constexpr const char* kPackListName = "packs.bin";
inline constexpr int kPackSide = 16;  ///< Tiles.
inline constexpr int kPackTiles = kPackSide * kPackSide;

using Checksum = std::array<std::uint8_t, 32>;  ///< SHA-256.

/// In packs.bin, ordered by level and number; numbers with the lowest byte first.
struct PackRecord {
  std::uint32_t level = 0, number = 0;
  std::uint64_t bytes = 0;  ///< Of the pack's file.
  Checksum records{};       ///< Of the pack's records.
};
static_assert(sizeof(PackRecord) == 48);

/// At the head of a pack, tile by tile and part by part within a tile.
struct TileRecord {
  std::uint64_t at = 0;
  std::uint32_t bytes = 0;  ///< As it is stored, packed; 0: the tile is outside the object.
  std::uint32_t none = 0;
  Checksum content{};  ///< Of the tile as it is read.
};
static_assert(sizeof(TileRecord) == 48);

/// What map.json says.
struct PublishedMap {
  std::string title, licence, citation, made_from;
  std::string set, state;  ///< Of the files that it was made from; empty: they say none.
  std::array<double, 16> view_from_file{};
  double first_x_mm = 0, first_y_mm = 0, spacing_mm = 0, factor = 2;
  double low_mm = 0, high_mm = 0;
  std::array<double, kOriginCount> cells_by_origin{};
  std::vector<GridSize> levels;
  std::vector<TilePart> parts;
  std::uint64_t pack_list_bytes = 0;
  std::string pack_list_sha256;

  friend bool operator==(const PublishedMap&, const PublishedMap&) = default;
};

/// Nothing in it can mislead a reader: sizes within bounds, numbers finite, parts in order.
bool makesSense(const PublishedMap& map) noexcept;

std::string jsonOf(const PublishedMap& map);
/// Nothing: the text is none of those. [worker process]
std::optional<PublishedMap> readPublishedMap(std::string_view json);

/// How it travels from the process that reads it.
std::string packed(const PublishedMap& map);
/// Nothing: it makes no sense.
std::optional<PublishedMap> unpackedMap(std::string bytes);

/// A tile in fewer bytes, lossless: of heights the four bytes apart, each as what it differs from
/// the one before; all by zlib.
std::vector<std::byte> packedTile(std::span<const std::byte> tile, TilePart part);
/// Nothing: they are none of such a tile. [worker process]
std::optional<std::vector<std::byte>> unpackedTile(std::span<const std::byte> stored,
                                                   TilePart part);

}  // namespace relievo
