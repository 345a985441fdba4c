// SPDX-License-Identifier: BSD-3-Clause
#include <zlib.h>

#include <new>

#include "core/io/web/published_map.h"
#include "core/io/worker/reader_guard.h"

namespace relievo {
namespace {

constexpr std::size_t kHeightBytes = 4;

/// The bytes of heights by their place, then differences. Its own inverse does not exist: `joined`.
std::vector<std::byte> split(std::span<const std::byte> heights) {
  const std::size_t count = heights.size() / kHeightBytes;
  std::vector<std::byte> bytes(heights.size());
  for (std::size_t k = 0; k < kHeightBytes; ++k) {
    std::uint8_t before = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const auto byte = static_cast<std::uint8_t>(heights[kHeightBytes * i + k]);
      bytes[k * count + i] = static_cast<std::byte>(byte - before);
      before = byte;
    }
  }
  return bytes;
}

std::vector<std::byte> joined(std::span<const std::byte> bytes) {
  const std::size_t count = bytes.size() / kHeightBytes;
  std::vector<std::byte> heights(bytes.size());
  for (std::size_t k = 0; k < kHeightBytes; ++k) {
    std::uint8_t before = 0;
    for (std::size_t i = 0; i < count; ++i) {
      before = static_cast<std::uint8_t>(before + static_cast<std::uint8_t>(bytes[k * count + i]));
      heights[kHeightBytes * i + k] = static_cast<std::byte>(before);
    }
  }
  return heights;
}

}  // namespace

std::vector<std::byte> packedTile(std::span<const std::byte> tile, TilePart part) {
  std::vector<std::byte> apart;
  if (part == TilePart::heights) {
    apart = split(tile);
    tile = apart;
  }
  uLongf bytes = ::compressBound(tile.size());
  std::vector<std::byte> stored(bytes);
  if (::compress2(reinterpret_cast<Bytef*>(stored.data()), &bytes,
                  reinterpret_cast<const Bytef*>(tile.data()), tile.size(), 6) != Z_OK) {
    throw std::bad_alloc();
  }
  stored.resize(bytes);
  return stored;
}

std::optional<std::vector<std::byte>> unpackedTile(std::span<const std::byte> stored,
                                                   TilePart part) {
  requireReadersAllowed("unpackedTile");
  std::vector<std::byte> tile(bytesOf(part));
  uLongf bytes = tile.size();
  const int end = ::uncompress(reinterpret_cast<Bytef*>(tile.data()), &bytes,
                               reinterpret_cast<const Bytef*>(stored.data()), stored.size());
  if (end != Z_OK || bytes != tile.size()) return std::nullopt;
  return part == TilePart::heights ? joined(tile) : tile;
}

}  // namespace relievo
