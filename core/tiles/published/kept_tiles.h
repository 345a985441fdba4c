// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <list>
#include <map>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace relievo {

/// Tiles of remote maps in a folder, up to a number of bytes for all maps together: those that were
/// used longest ago go first. Whoever takes one compares its checksum, so nothing is brought to the
/// disk at once, and what is damaged is fetched anew. Never an error: what cannot be kept is not.
/// [any thread but the haptic loop]
class KeptTiles {
 public:
  /// @param root  of all maps @param map  this map's folder within it
  KeptTiles(const std::filesystem::path& root, const std::string& map, std::uint64_t most_bytes);

  std::optional<std::vector<std::byte>> get(const std::string& name, std::size_t bytes);
  void put(const std::string& name, std::span<const std::byte> bytes);
  void remove(const std::string& name);
  std::uint64_t bytes() const;

 private:
  struct Entry {
    std::filesystem::path file;
    std::uint64_t bytes = 0;
  };
  using Place = std::list<Entry>::iterator;
  void add(const std::filesystem::path& file, std::uint64_t bytes);
  void drop(const std::filesystem::path& file);

  std::filesystem::path folder_;
  std::uint64_t most_bytes_, bytes_ = 0;
  mutable std::mutex mutex_;
  std::list<Entry> newest_first_;
  std::map<std::filesystem::path, Place> places_;
  std::uint64_t next_name_ = 0;
};

/// Where maps from the web are kept: $XDG_CACHE_HOME/relievo/maps, or ~/.cache/relievo/maps.
std::filesystem::path keptMapsFolder();
/// 2 GB, or what RELIEVO_MAP_CACHE_MB says.
std::uint64_t keptMapsLimit();

}  // namespace relievo
