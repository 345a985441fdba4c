// SPDX-License-Identifier: BSD-3-Clause
#include "core/tiles/published/kept_tiles.h"

#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <fstream>
#include <string_view>
#include <tuple>

namespace relievo {
namespace {

namespace fs = std::filesystem;

constexpr const char* kTileEnding = ".tile";
constexpr const char* kTilesFolder = "tiles";

std::string variable(const char* name) {
  const char* const value = std::getenv(name);  // NOLINT(concurrency-mt-unsafe)
  return value == nullptr ? "" : value;
}

}  // namespace

fs::path keptMapsFolder() {
  // Relative paths are to be ignored (XDG Base Directory Specification).
  fs::path cache = variable("XDG_CACHE_HOME");
  if (!cache.is_absolute()) cache = fs::path(variable("HOME")) / ".cache";
  if (!cache.is_absolute()) cache = fs::temp_directory_path();
  return cache / "relievo" / "maps";
}

std::uint64_t keptMapsLimit() {
  constexpr std::uint64_t kMegabytes = 2000;
  const std::string text = variable("RELIEVO_MAP_CACHE_MB");
  std::uint64_t megabytes = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), megabytes);
  const bool given =
      error == std::errc() && end == text.data() + text.size() && megabytes <= 1'000'000'000;
  return (given ? megabytes : kMegabytes) * 1'000'000;
}

KeptTiles::KeptTiles(const fs::path& root, const std::string& map, std::uint64_t most_bytes)
    : folder_(root / map / kTilesFolder), most_bytes_(most_bytes) {
  std::error_code error;
  fs::create_directories(folder_, error);
  using Found = std::tuple<fs::file_time_type, fs::path, std::uint64_t>;
  std::vector<Found> found;
  for (const auto& one : fs::directory_iterator(root, error)) {
    std::error_code none;
    for (const auto& tile : fs::directory_iterator(one.path() / kTilesFolder, none)) {
      if (tile.path().extension() != kTileEnding || !tile.is_regular_file(none)) continue;
      found.emplace_back(tile.last_write_time(none), tile.path(), tile.file_size(none));
    }
  }
  std::sort(found.begin(), found.end());
  for (const auto& [time, file, bytes] : found) add(file, bytes);
}

/// As the newest; the oldest go.
void KeptTiles::add(const fs::path& file, std::uint64_t bytes) {
  drop(file);
  newest_first_.push_front({file, bytes});
  places_[file] = newest_first_.begin();
  bytes_ += bytes;
  while (bytes_ > most_bytes_ && !newest_first_.empty()) {
    const fs::path oldest = newest_first_.back().file;
    std::error_code ignored;
    fs::remove(oldest, ignored);
    drop(oldest);
  }
}

void KeptTiles::drop(const fs::path& file) {
  const auto found = places_.find(file);
  if (found == places_.end()) return;
  bytes_ -= found->second->bytes;
  newest_first_.erase(found->second);
  places_.erase(found);
}

std::optional<std::vector<std::byte>> KeptTiles::get(const std::string& name, std::size_t bytes) {
  const fs::path file = folder_ / (name + kTileEnding);
  {
    const std::scoped_lock lock(mutex_);
    const auto found = places_.find(file);
    if (found == places_.end() || found->second->bytes != bytes) return std::nullopt;
    newest_first_.splice(newest_first_.begin(), newest_first_, found->second);
  }
  std::ifstream in(file, std::ios::binary);
  std::vector<std::byte> content(bytes);
  in.read(reinterpret_cast<char*>(content.data()), static_cast<std::streamsize>(bytes));
  if (!in) return std::nullopt;
  std::error_code ignored;
  fs::last_write_time(file, fs::file_time_type::clock::now(), ignored);  // For the next start.
  return content;
}

void KeptTiles::put(const std::string& name, std::span<const std::byte> bytes) {
  if (bytes.size() > most_bytes_) return;
  const fs::path file = folder_ / (name + kTileEnding);
  fs::path beside = file;
  {
    const std::scoped_lock lock(mutex_);
    beside += "." + std::to_string(::getpid()) + "." + std::to_string(next_name_++);
  }
  std::error_code error;
  {
    std::ofstream out(beside, std::ios::binary);
    out.write(reinterpret_cast<const char*>(bytes.data()),
              static_cast<std::streamsize>(bytes.size()));
    out.close();
    if (out) fs::rename(beside, file, error);
    if (!out || error) {
      fs::remove(beside, error);
      return;
    }
  }
  const std::scoped_lock lock(mutex_);
  add(file, bytes.size());
}

void KeptTiles::remove(const std::string& name) {
  const fs::path file = folder_ / (name + kTileEnding);
  const std::scoped_lock lock(mutex_);
  std::error_code ignored;
  fs::remove(file, ignored);
  drop(file);
}

std::uint64_t KeptTiles::bytes() const {
  const std::scoped_lock lock(mutex_);
  return bytes_;
}

}  // namespace relievo
