// SPDX-License-Identifier: BSD-3-Clause
#include "core/tiles/tile_cache.h"

#include <utility>

namespace relievo {

TileCache::Tile TileCache::find(const Key& key) {
  const std::scoped_lock lock(mutex_);
  const auto found = places_.find(key);
  if (found == places_.end()) return nullptr;
  newest_first_.splice(newest_first_.begin(), newest_first_, found->second);
  return found->second->tile;
}

TileCache::Tile TileCache::get(const Key& key,
                               const std::function<std::vector<std::byte>()>& load) {
  if (Tile here = find(key)) return here;
  ++loads_;
  auto tile = std::make_shared<const std::vector<std::byte>>(load());
  const std::scoped_lock lock(mutex_);
  const auto found = places_.find(key);
  if (found != places_.end()) return found->second->tile;  // Another thread was faster.
  newest_first_.push_front({.key = key, .tile = tile});
  places_[key] = newest_first_.begin();
  bytes_ += tile->size();
  while (bytes_ > most_bytes_ && newest_first_.size() > 1) {
    const Entry& oldest = newest_first_.back();
    bytes_ -= oldest.tile->size();
    places_.erase(oldest.key);
    newest_first_.pop_back();
  }
  return tile;
}

}  // namespace relievo
