// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <list>
#include <memory>
#include <mutex>
#include <unordered_map>
#include <vector>

namespace relievo {

/// Tiles that were used last, up to a number of bytes. Its lock is held for a look-up only, never
/// while a tile is read, and never by the haptic loop (docs/adr/0038). [any thread]
class TileCache {
 public:
  using Tile = std::shared_ptr<const std::vector<std::byte>>;
  struct Key {
    int level = 0, kind = 0, tile = 0;
    friend bool operator==(const Key&, const Key&) = default;
  };

  explicit TileCache(std::size_t bytes) : most_bytes_(bytes) {}

  /// The tile, made by `load` if it is not here. What `load` throws is thrown.
  Tile get(const Key& key, const std::function<std::vector<std::byte>()>& load);

  /// The tile if it is here, else null; loads nothing.
  Tile find(const Key& key);

  std::size_t loads() const noexcept { return loads_; }

 private:
  struct Entry {
    Key key;
    Tile tile;
  };
  struct Hash {
    std::size_t operator()(const Key& key) const noexcept {
      const auto tile = static_cast<std::uint64_t>(key.tile);
      return static_cast<std::size_t>((tile << 8U) ^
                                      static_cast<std::uint64_t>(4 * key.level + key.kind));
    }
  };

  std::mutex mutex_;
  std::size_t most_bytes_, bytes_ = 0;
  std::list<Entry> newest_first_;
  std::unordered_map<Key, std::list<Entry>::iterator, Hash> places_;
  std::atomic<std::size_t> loads_ = 0;
};

}  // namespace relievo
