// SPDX-License-Identifier: BSD-3-Clause
#include "core/io/las/laz_points.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include "core/io/file_check.h"
#include "core/io/read_scan.h"
#include "core/message/catalogue.h"

namespace relievo {
namespace {

constexpr std::size_t kChunksKept = 4;
constexpr std::size_t kBytesKept = 32 << 20;
constexpr std::uint64_t kMostPoints = 2'000'000;  ///< Of a chunk.
constexpr std::uint64_t kMostBytes = 64 << 20;
constexpr std::size_t kBlock = 4096;  ///< Points unpacked at once.

}  // namespace

LazPoints::LazPoints(LazBytesSource source, LazFile laz, std::filesystem::path file,
                     const LazKept& kept, const Task& task)
    : source_(std::move(source)),
      laz_(std::move(laz)),
      file_(std::move(file)),
      kept_bytes_(kept.bytes),
      wanted_(kept.wanted),
      task_{.stop = task.stop, .progress = {}} {
  for (const LazChunk& chunk : laz_.chunks) {
    if (chunk.points <= kMostPoints && chunk.bytes <= kMostBytes) continue;
    throwReadError(file_,
                   said<MessageId::refused_laz_one_block>(CountArgument::grouped(chunk.points)));
  }
}

LazPoints::~LazPoints() = default;

std::size_t LazPoints::keptBytes() const noexcept {
  std::size_t unpacked = 0, packed = 0;
  for (const LazChunk& chunk : laz_.chunks) {
    unpacked = std::max(unpacked, static_cast<std::size_t>(chunk.points) * kept_bytes_);
    packed = std::max(packed, static_cast<std::size_t>(chunk.bytes));
  }
  return std::max(unpacked, std::min(kChunksKept * unpacked, kBytesKept)) + kChunksKept * packed;
}

/// One that holds the chunk, if there is any.
std::unique_ptr<LazPoints::Reader> LazPoints::takeReader(std::size_t chunk) const {
  const std::scoped_lock lock(mutex_);
  if (readers_.empty()) return std::make_unique<Reader>();
  const auto holds = [chunk](const std::unique_ptr<Reader>& reader) {
    return std::any_of(reader->begin(), reader->end(),
                       [chunk](const OpenChunk& open) { return open.index == chunk; });
  };
  auto found = std::find_if(readers_.begin(), readers_.end(), holds);
  if (found == readers_.end()) --found;
  std::unique_ptr<Reader> reader = std::move(*found);
  readers_.erase(found);
  return reader;
}

LazPoints::OpenChunk& LazPoints::open(Reader& reader, std::size_t chunk) const {
  const auto found = std::find_if(reader.begin(), reader.end(),
                                  [chunk](const OpenChunk& open) { return open.index == chunk; });
  if (found != reader.end()) {
    std::rotate(reader.begin(), found, found + 1);
    return reader.front();
  }
  const LazChunk& place = laz_.chunks[chunk];
  OpenChunk opened{.index = chunk,
                   .bytes = std::make_unique<std::string>(source_.read(place.at, place.bytes)),
                   .decoder = {},
                   .kept = {}};
  opened.decoder = openLazChunk(laz_.layout, *opened.bytes, place.points, wanted_);
  std::size_t bytes = static_cast<std::size_t>(place.points) * kept_bytes_;
  std::size_t stay = 0;
  for (; stay < reader.size() && stay + 1 < kChunksKept; ++stay) {
    bytes += static_cast<std::size_t>(laz_.chunks[reader[stay].index].points) * kept_bytes_;
    if (bytes > kBytesKept) break;
  }
  reader.resize(stay);
  reader.insert(reader.begin(), std::move(opened));
  return reader.front();
}

void LazPoints::unpack(OpenChunk& chunk, std::uint64_t points) const {
  const std::uint64_t all = laz_.chunks[chunk.index].points;
  std::vector<char> records;
  for (std::uint64_t done = chunk.kept.size() / kept_bytes_; done < points;) {
    task_.check();
    const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(kBlock, all - done));
    records.resize(count * laz_.layout.record_bytes);
    chunk.decoder->decode(records.data(), count);
    chunk.kept.reserve(static_cast<std::size_t>(all) * kept_bytes_);
    for (std::size_t i = 0; i < count; ++i) {
      const char* const record = records.data() + i * laz_.layout.record_bytes;
      chunk.kept.insert(chunk.kept.end(), record, record + kept_bytes_);
    }
    done += count;
  }
  if (chunk.kept.size() < all * kept_bytes_) return;
  chunk.decoder.reset();
  chunk.bytes.reset();
}

void LazPoints::read(std::uint64_t first, std::size_t count, char* out) const {
  auto chunk = std::upper_bound(laz_.chunks.begin(), laz_.chunks.end(), first,
                                [](std::uint64_t at, const LazChunk& c) { return at < c.first; });
  --chunk;
  std::unique_ptr<Reader> reader =
      takeReader(static_cast<std::size_t>(chunk - laz_.chunks.begin()));
  for (; count > 0; ++chunk) {
    const auto index = static_cast<std::size_t>(chunk - laz_.chunks.begin());
    const std::uint64_t skip = first - chunk->first;
    const std::uint64_t here = std::min<std::uint64_t>(count, chunk->points - skip);
    try {
      OpenChunk& opened = open(*reader, index);
      unpack(opened, skip + here);
      std::memcpy(out, opened.kept.data() + skip * kept_bytes_, here * kept_bytes_);
    } catch (const LazDamage& damage) {
      refuseLazChunk(file_, index, damage);
    }
    out += here * kept_bytes_;
    first += here;
    count -= static_cast<std::size_t>(here);
  }
  const std::scoped_lock lock(mutex_);
  readers_.push_back(std::move(reader));
}

std::vector<PointRange> LazPoints::cheapSample(std::uint64_t wanted) const {
  int level = -1;
  std::uint64_t sum = 0;
  while (laz_.is_copc) {
    std::uint64_t more = 0;
    bool is_last = true;
    for (const LazChunk& chunk : laz_.chunks) {
      if (chunk.level == level + 1) more += chunk.points;
      if (chunk.level > level) is_last = false;
    }
    if (is_last || sum + more > wanted) break;
    sum += more;
    ++level;
  }
  const std::uint64_t each = std::max<std::uint64_t>(1, wanted / laz_.chunks.size());
  std::vector<PointRange> ranges;
  for (const LazChunk& chunk : laz_.chunks) {
    if (level < 0) {
      ranges.push_back({chunk.first, std::min(each, chunk.points)});
    } else if (chunk.level <= level) {
      ranges.push_back({chunk.first, chunk.points});
    }
  }
  return ranges;
}

}  // namespace relievo
