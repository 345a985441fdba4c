// SPDX-License-Identifier: BSD-3-Clause
#include "core/tiles/published/published_tiles.h"

#include <algorithm>
#include <cstring>
#include <fstream>
#include <iterator>
#include <optional>

#include "core/base/failure.h"
#include "core/file/atomic_file.h"
#include "core/hash/sha256.h"
#include "core/io/file_check.h"
#include "core/io/worker/answer_text.h"
#include "core/tiles/tile_layout.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;

constexpr const char* kAddressName = "address";
constexpr std::size_t kMostRecords = 512;  // Packs at once; 12 to 50 MB.

std::string textOfFile(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

std::string packFile(std::uint32_t level, std::uint32_t number) {
  return "L" + std::to_string(level) + ".p" + std::to_string(number) + ".tiles";
}

int packsAcross(GridSize size) {
  return (TileLayout{size}.across() + kPackSide - 1) / kPackSide;
}

std::vector<std::byte> outsideTile(TilePart part) {
  return std::vector<std::byte>(bytesOf(part), part == TilePart::origins
                                                   ? static_cast<std::byte>(CellStatus::outside)
                                                   : std::byte{0});
}

[[noreturn]] void refuse(const std::string& place, const std::string& file,
                         const WebLink::Answer& answer) {
  switch (answer.end) {
    case WebEnd::missing:
      throw failure<MessageId::published_file_missing>(printable(place), file, answer.why);
    case WebEnd::damaged:
    case WebEnd::good:
      throw failure<MessageId::published_file_damaged>(printable(place), file);
    case WebEnd::unreachable:
    case WebEnd::ended:
      break;
  }
  throw WebLost(said<MessageId::web_map_unreachable>(printable(place), answer.why));
}

struct Manifest {
  std::string text;
  PublishedMap map;
};

Manifest manifestIn(const std::string& place, const std::vector<std::byte>& answer) {
  Unpacker unpacker({reinterpret_cast<const char*>(answer.data()), answer.size()});
  Manifest manifest;
  manifest.text = unpacker.text();
  auto map = unpackedMap(unpacker.text());
  if (!map) throw failure<MessageId::published_file_damaged>(printable(place), kPublishedName);
  manifest.map = std::move(*map);
  return manifest;
}

/// The folder of a published map's address.
std::string folderOf(std::string address) {
  const std::string name = std::string("/") + kPublishedName;
  if (address.ends_with(name)) address.resize(address.size() - name.size());
  while (address.ends_with('/')) address.pop_back();
  return address;
}

void writeKept(const fs::path& file, const std::string& text) {
  AtomicFile out(file);
  out.write(text);
  out.commit();
}

}  // namespace

Checksum checksumOf(std::span<const std::byte> bytes) {
  Sha256 sum;
  sum.add(bytes);
  const std::string digits = sum.finish();
  const auto value = [](char digit) { return digit <= '9' ? digit - '0' : digit - 'a' + 10; };
  Checksum checksum{};
  for (std::size_t i = 0; i < checksum.size(); ++i) {
    checksum[i] = static_cast<std::uint8_t>(16 * value(digits[2 * i]) + value(digits[2 * i + 1]));
  }
  return checksum;
}

std::string addressOfKeptMap(const fs::path& manifest) {
  std::error_code error;
  const fs::path folder = fs::weakly_canonical(manifest, error).parent_path();
  const fs::path root = fs::weakly_canonical(keptMapsFolder(), error);
  if (error || folder.parent_path() != root) return {};
  const std::string address = textOfFile(folder / kAddressName);
  return isWebAddress(address) ? address : std::string();
}

PublishedTiles::PublishedTiles(const fs::path& manifest) : manifest_(fs::absolute(manifest)) {
  checkedFileSize(manifest_);
  place_ = manifest_.parent_path().string();
  const auto answer = link_.wait(link_.ask(WebAsk::published, manifest_.string()));
  if (answer.end != WebEnd::good) refuse(place_, kPublishedName, answer);
  map_ = manifestIn(place_, answer.bytes).map;
  if (const std::string address = addressOfKeptMap(manifest_); !address.empty()) {
    place_ = address;
    kept_ =
        std::make_unique<KeptTiles>(manifest_.parent_path().parent_path(),
                                    manifest_.parent_path().filename().string(), keptMapsLimit());
  }
  readPackList();
}

std::vector<std::byte> PublishedTiles::fetch(WebAsk what, const std::string& file,
                                             std::uint64_t first, std::uint32_t count,
                                             const Task& task, TilePart part) const {
  constexpr int kTries = 2;
  for (int i = 1;; ++i) {
    auto answer = link_.wait(link_.ask(what, fetchName(place_, file), first, count, part), task);
    if (answer.end == WebEnd::good) return std::move(answer.bytes);
    const bool may_come = answer.end == WebEnd::unreachable || answer.end == WebEnd::ended;
    if (!may_come || i == kTries) refuse(place_, file, answer);
  }
}

void PublishedTiles::readPackList() {
  if (map_.pack_list_bytes == 0) return;  // Nothing of it is inside the object.
  const fs::path beside = manifest_.parent_path() / kPackListName;
  std::string list = kept_ ? textOfFile(beside) : std::string();
  if (list.size() != map_.pack_list_bytes || sha256OfText(list) != map_.pack_list_sha256) {
    const auto bytes = fetch(WebAsk::bytes, kPackListName, 0,
                             static_cast<std::uint32_t>(map_.pack_list_bytes), {});
    list.assign(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    if (sha256OfText(list) != map_.pack_list_sha256) {
      throw failure<MessageId::published_file_damaged>(printable(place_), kPackListName);
    }
    if (kept_) writeKept(beside, list);
  }
  packs_.resize(list.size() / sizeof(PackRecord));
  std::memcpy(packs_.data(), list.data(), packs_.size() * sizeof(PackRecord));
  const auto place = [](const PackRecord& pack) { return std::pair(pack.level, pack.number); };
  const bool in_order =
      std::is_sorted(packs_.begin(), packs_.end(),
                     [&](const auto& a, const auto& b) { return place(a) < place(b); });
  const bool fits = std::all_of(packs_.begin(), packs_.end(), [this](const PackRecord& pack) {
    return pack.level < map_.levels.size() &&
           pack.bytes >= kPackTiles * map_.parts.size() * sizeof(TileRecord);
  });
  if (!in_order || !fits) {
    throw failure<MessageId::published_file_damaged>(printable(place_), kPackListName);
  }
}

std::vector<fs::path> PublishedTiles::files() const {
  if (isRemote()) return {};
  const fs::path folder = manifest_.parent_path();
  std::vector<fs::path> files;
  if (!packs_.empty()) files.push_back(folder / kPackListName);
  for (const PackRecord& pack : packs_) files.push_back(folder / packFile(pack.level, pack.number));
  return files;
}

const PackRecord* PublishedTiles::packOf(int level, int pack) const {
  const auto wanted =
      std::pair(static_cast<std::uint32_t>(level), static_cast<std::uint32_t>(pack));
  const auto found = std::lower_bound(
      packs_.begin(), packs_.end(), wanted,
      [](const PackRecord& a, const auto& b) { return std::pair(a.level, a.number) < b; });
  const bool there = found != packs_.end() && std::pair(found->level, found->number) == wanted;
  return there ? &*found : nullptr;
}

PublishedTiles::Records PublishedTiles::recordsOf(const PackRecord& pack, const Task& task) const {
  const std::pair key(pack.level, pack.number);
  {
    const std::scoped_lock lock(mutex_);
    const auto found = records_.find(key);
    if (found != records_.end()) return found->second;
  }
  const std::size_t count = kPackTiles * map_.parts.size();
  const std::string file = packFile(pack.level, pack.number);
  const std::string name = file + ".records";
  const std::size_t bytes = count * sizeof(TileRecord);
  auto content = kept_ ? kept_->get(name, bytes) : std::nullopt;
  if (!content || checksumOf(*content) != pack.records) {
    content = fetch(WebAsk::bytes, file, 0, static_cast<std::uint32_t>(bytes), task);
    if (checksumOf(*content) != pack.records) {
      throw failure<MessageId::published_file_damaged>(printable(place_), file);
    }
    if (kept_) kept_->put(name, *content);
  }
  auto records = std::make_shared<std::vector<TileRecord>>(count);
  std::memcpy(records->data(), content->data(), bytes);
  const std::scoped_lock lock(mutex_);
  if (records_.size() >= kMostRecords) records_.clear();
  return records_[key] = std::move(records);
}

std::vector<std::byte> PublishedTiles::read(int level, TilePart part, int tile,
                                            const Task& task) const {
  const GridSize size = map_.levels.at(static_cast<std::size_t>(level));
  const int across = TileLayout{size}.across();
  const int col = tile % across, row = tile / across;
  const PackRecord* const pack =
      packOf(level, row / kPackSide * packsAcross(size) + col / kPackSide);
  const auto place = std::find(map_.parts.begin(), map_.parts.end(), part);
  if (pack == nullptr || place == map_.parts.end()) return outsideTile(part);
  const auto slot = static_cast<std::size_t>(row % kPackSide * kPackSide + col % kPackSide);
  const std::size_t number =
      slot * map_.parts.size() + static_cast<std::size_t>(place - map_.parts.begin());
  const TileRecord record = (*recordsOf(*pack, task))[number];
  if (record.bytes == 0) return outsideTile(part);
  const std::string file = packFile(pack->level, pack->number);
  const std::string name = file + "." + std::to_string(number);
  if (kept_) {
    auto tile_kept = kept_->get(name, bytesOf(part));
    if (tile_kept && checksumOf(*tile_kept) == record.content) return std::move(*tile_kept);
    if (tile_kept) kept_->remove(name);
  }
  if (record.at > pack->bytes || record.bytes > pack->bytes - record.at) {
    throw failure<MessageId::published_file_damaged>(printable(place_), file);
  }
  auto content = fetch(WebAsk::tile, file, record.at, record.bytes, task, part);
  ++fetched_;
  if (content.size() != bytesOf(part) || checksumOf(content) != record.content) {
    throw failure<MessageId::published_tile_damaged>(printable(place_), level, file);
  }
  if (kept_) kept_->put(name, content);
  return content;
}

namespace {

fs::path knownAs(const std::string& place) {
  return keptMapsFolder() / ("known." + sha256OfText(place));
}

}  // namespace

std::optional<fs::path> keptMap(const std::string& address) {
  const fs::path known = knownAs(folderOf(address));
  const fs::path before = keptMapsFolder() / textOfFile(known) / kPublishedName;
  std::error_code error;
  if (!fs::is_regular_file(known, error) || !fs::is_regular_file(before, error)) return {};
  return before;
}

WebMap webMap(const std::string& address, const Task& task) {
  const std::string place = folderOf(address);
  const fs::path root = keptMapsFolder();
  WebLink link;
  const auto answer =
      link.wait(link.ask(WebAsk::published, fetchName(place, kPublishedName)), task);
  if (answer.end == WebEnd::unreachable || answer.end == WebEnd::ended) {
    if (const auto before = keptMap(address)) return {.manifest = *before, .from_before = true};
  }
  if (answer.end == WebEnd::damaged) {
    throw failure<MessageId::web_no_published_map>(printable(place));
  }
  if (answer.end != WebEnd::good) refuse(place, kPublishedName, answer);
  const Manifest manifest = manifestIn(place, answer.bytes);
  const std::string identity = sha256OfText(manifest.text + place).substr(0, 32);
  const fs::path folder = root / identity;
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) cannotWrite(folder, error.message());
  if (textOfFile(folder / kAddressName) != place) writeKept(folder / kAddressName, place);
  if (textOfFile(folder / kPublishedName) != manifest.text) {
    writeKept(folder / kPublishedName, manifest.text);
  }
  if (textOfFile(knownAs(place)) != identity) writeKept(knownAs(place), identity);
  return {.manifest = folder / kPublishedName, .from_before = false};
}

}  // namespace relievo
