// SPDX-License-Identifier: BSD-3-Clause
#include "core/tiles/published/publish.h"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>

#include "core/base/failure.h"
#include "core/base/threads.h"
#include "core/file/atomic_file.h"
#include "core/file/output_set.h"
#include "core/hash/sha256.h"
#include "core/io/file_check.h"
#include "core/tiles/published/published_tiles.h"
#include "core/tiles/tile_layout.h"
#include "core/tiles/tiled_map.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;

int packsAcross(GridSize size) noexcept {
  return (TileLayout{size}.across() + kPackSide - 1) / kPackSide;
}

/// A tile of a pack as it is stored.
struct StoredTile {
  std::vector<std::vector<std::byte>> parts;  ///< None: outside.
  std::vector<Checksum> contents;
};

StoredTile stored(const std::vector<std::vector<std::byte>>& parts,
                  const std::vector<TilePart>& kinds) {
  StoredTile tile;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    tile.contents.push_back(checksumOf(parts[i]));
    tile.parts.push_back(packedTile(parts[i], kinds[i]));
  }
  return tile;
}

/// By as many threads as may be busy. What one throws is thrown.
template <class Work>
void forEach(std::size_t count, const Task& task, const Work& work) {
  std::atomic<std::size_t> next = 0;
  std::exception_ptr first;
  std::mutex mutex;
  const auto run = [&] {
    try {
      for (std::size_t i = next++; i < count; i = next++) {
        task.check();
        work(i);
      }
    } catch (...) {
      next = count;
      const std::scoped_lock lock(mutex);
      if (!first) first = std::current_exception();
    }
  };
  {
    std::vector<std::jthread> threads;
    for (int i = 1; i < threadCount(0); ++i) threads.emplace_back(run);
    run();
  }
  if (first) std::rethrow_exception(first);
}

}  // namespace

int packsOf(GridSize size) noexcept {
  const int down = (TileLayout{size}.down() + kPackSide - 1) / kPackSide;
  return packsAcross(size) * down;
}

std::vector<int> tilesOfPack(GridSize size, int pack) {
  const TileLayout layout{size};
  const int left = pack % packsAcross(size) * kPackSide, top = pack / packsAcross(size) * kPackSide;
  std::vector<int> tiles;
  for (int row = top; row < std::min(top + kPackSide, layout.down()); ++row) {
    for (int col = left; col < std::min(left + kPackSide, layout.across()); ++col) {
      tiles.push_back(row * layout.across() + col);
    }
  }
  return tiles;
}

PublishedFolder::PublishedFolder(const fs::path& folder, PublishedMap map)
    : folder_(folder.has_filename() ? folder : folder.parent_path()), map_(std::move(map)) {
  std::error_code error;
  const bool is_there = fs::symlink_status(folder_, error).type() != fs::file_type::not_found;
  const bool is_empty_folder = fs::is_directory(folder_, error) && fs::is_empty(folder_, error);
  if (is_there && !(is_empty_folder && !error)) {
    throw failure<MessageId::publish_folder_taken>(folder_);
  }
  // Beside its place, so that it can take it in one step.
  const fs::path parent = fs::absolute(folder_).parent_path();
  std::string name = (parent / ("." + folder_.filename().string() + ".XXXXXX")).string();
  if (::mkdtemp(name.data()) == nullptr) cannotWrite(folder_, std::strerror(errno));
  made_in_ = name;
}

PublishedFolder::~PublishedFolder() {
  if (made_in_.empty()) return;
  std::error_code ignored;
  fs::remove_all(made_in_, ignored);
}

void PublishedFolder::write(const std::string& name, std::string_view bytes) {
  try {
    AtomicFile out(made_in_ / name);
    out.write(bytes);
    out.commit();
  } catch (const CannotWrite& error) {
    cannotWrite(folder_ / name, error.reason);
  }
  done_.bytes += bytes.size();
}

void PublishedFolder::add(int level, int pack, const TileOf& tile, const Task& task) {
  const GridSize size = map_.levels[static_cast<std::size_t>(level)];
  const std::vector<int> tiles = tilesOfPack(size, pack);
  std::vector<StoredTile> made(tiles.size());
  forEach(tiles.size(), task, [&](std::size_t i) { made[i] = stored(tile(tiles[i]), map_.parts); });
  const std::size_t parts = map_.parts.size();
  std::vector<TileRecord> records(kPackTiles * parts);
  const std::size_t head = records.size() * sizeof(TileRecord);
  std::string content(head, '\0');
  bool any = false;
  const int across = TileLayout{size}.across();
  for (std::size_t i = 0; i < tiles.size(); ++i) {
    const int row = tiles[i] / across % kPackSide, col = tiles[i] % across % kPackSide;
    ++(made[i].parts.empty() ? done_.outside_tiles : done_.tiles);
    for (std::size_t k = 0; k < made[i].parts.size(); ++k) {
      const std::vector<std::byte>& bytes = made[i].parts[k];
      records[static_cast<std::size_t>(row * kPackSide + col) * parts + k] = {
          .at = content.size(),
          .bytes = static_cast<std::uint32_t>(bytes.size()),
          .none = 0,
          .content = made[i].contents[k]};
      content.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
      done_.bytes_of_tiles += bytesOf(map_.parts[k]);
      any = true;
    }
  }
  if (!any) return;
  std::memcpy(content.data(), records.data(), head);
  write("L" + std::to_string(level) + ".p" + std::to_string(pack) + ".tiles", content);
  packs_.push_back({.level = static_cast<std::uint32_t>(level),
                    .number = static_cast<std::uint32_t>(pack),
                    .bytes = content.size(),
                    .records = checksumOf(std::as_bytes(std::span(records)))});
}

Published PublishedFolder::finish() {
  const std::string_view list(reinterpret_cast<const char*>(packs_.data()),
                              packs_.size() * sizeof(PackRecord));
  if (!list.empty()) write(kPackListName, list);
  map_.pack_list_bytes = list.size();
  map_.pack_list_sha256 = sha256OfText(list);
  const std::string json = jsonOf(map_);
  write(kPublishedName, json);
  done_.packs = packs_.size();
  done_.sha256 = sha256OfText(json);
  std::error_code error;
  fs::permissions(made_in_, fs::perms(0755), error);  // Servers run as somebody else.
  fs::rename(made_in_, folder_, error);
  if (error) cannotWrite(folder_, error.message());
  made_in_.clear();
  bringNamesToDisk(fs::absolute(folder_).parent_path());
  return done_;
}

Published publish(const TiledMap& map, const fs::path& folder, const PublishWords& words,
                  const Task& task) {
  PublishedMap facts;
  facts.title = words.title;
  facts.licence = words.licence;
  facts.citation = words.citation;
  facts.made_from = printable(map.file().filename().string());
  facts.set = map.set();
  facts.state = map.state();
  facts.view_from_file = map.viewFromFile().m;
  const GridFrame& finest = map.frames().front();
  facts.first_x_mm = finest.first_x_mm;
  facts.first_y_mm = finest.first_y_mm;
  facts.spacing_mm = finest.spacing_mm;
  facts.factor = map.ladder().factor;
  facts.low_mm = map.heights().min_mm;
  facts.high_mm = map.heights().max_mm;
  facts.parts = {TilePart::heights, TilePart::origins};
  const auto cells = static_cast<double>(finest.size.count());
  std::transform(map.shares().begin(), map.shares().end(), facts.cells_by_origin.begin(),
                 [cells](double share) { return std::round(share * cells); });
  int all = 0, done = 0;
  for (const GridFrame& frame : map.frames()) {
    facts.levels.push_back(frame.size);
    all += packsOf(frame.size);
  }
  if (map.hasColours()) facts.parts.push_back(TilePart::colours);
  if (map.hasIntensities()) facts.parts.push_back(TilePart::intensities);
  PublishedFolder out(folder, facts);
  for (int level = 0; level < static_cast<int>(facts.levels.size()); ++level) {
    for (int pack = 0; pack < packsOf(facts.levels[static_cast<std::size_t>(level)]); ++pack) {
      task.report("Publishing", static_cast<double>(done++) / all);
      const auto tile = [&](int number) {
        std::vector<std::vector<std::byte>> parts;
        for (const TilePart part : facts.parts) {
          const auto cells_of_part = map.tile({level}, part, number);
          parts.emplace_back(cells_of_part->begin(), cells_of_part->end());
        }
        const std::byte outside{static_cast<unsigned char>(CellStatus::outside)};
        const auto is_none = [](std::byte b) { return b == std::byte{0}; };
        const bool is_outside =
            std::all_of(parts[1].begin(), parts[1].end(),
                        [outside](std::byte origin) { return origin == outside; }) &&
            std::all_of(parts.begin(), parts.end(), [&](const auto& bytes) {
              return &bytes == &parts[1] || std::all_of(bytes.begin(), bytes.end(), is_none);
            });
        if (is_outside) parts.clear();
        return parts;
      };
      out.add(level, pack, tile, task);
    }
  }
  return out.finish();
}

}  // namespace relievo
