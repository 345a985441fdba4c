// SPDX-License-Identifier: BSD-3-Clause
#include "core/io/las/las_records.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <numeric>
#include <system_error>
#include <thread>

#include "core/base/control_group.h"
#include "core/io/formats/scalar.h"
#include "core/message/catalogue.h"

namespace relievo {
namespace {

constexpr std::size_t kBlock = 1 << 16;  ///< Records given at once.
constexpr std::size_t kMostThreads = 16;
constexpr std::size_t kBatchBytes = 64 << 20;         ///< Records unpacked before they are taken.
constexpr std::uint64_t kLongChunkBytes = 256 << 20;  ///< More is not unpacked at once.
constexpr std::size_t kReturnsAt = 14;

LazBytesSource sourceOf(std::string_view bytes) {
  return {.size = bytes.size(), .read = [bytes](std::uint64_t at, std::uint64_t count) {
            return std::string(
                bytes.substr(static_cast<std::size_t>(at), static_cast<std::size_t>(count)));
          }};
}

std::size_t threadsFor(int wanted) {
  if (wanted > 0) return static_cast<std::size_t>(wanted);
  return std::min(static_cast<std::size_t>(usableCores()), kMostThreads);
}

/// Points by return that the header states, where their sum is that of the points.
std::optional<std::vector<std::uint64_t>> statedReturns(std::string_view bytes,
                                                        const LasHeader& header) {
  std::vector<std::uint64_t> counts;
  if (header.minor >= 4) {
    for (std::size_t i = 0; i < 15; ++i) {
      counts.push_back(loadAs<std::uint64_t>(bytes.data() + 255 + 8 * i, ByteOrder::little));
    }
  } else {
    for (std::size_t i = 0; i < 5; ++i) {
      counts.push_back(loadAs<std::uint32_t>(bytes.data() + 111 + 4 * i, ByteOrder::little));
    }
  }
  const bool is_whole =
      std::accumulate(counts.begin(), counts.end(), std::uint64_t{0}) == header.points;
  return is_whole ? std::optional(counts) : std::nullopt;
}

}  // namespace

LasRecords::LasRecords(const ReadJob& job, const LasHeader& header, const LazWanted& wanted,
                       int threads)
    : job_(job), header_(header), wanted_(wanted), threads_(threadsFor(threads)), seen_{} {
  seen_.least.fill(std::numeric_limits<std::int32_t>::max());
  seen_.most.fill(std::numeric_limits<std::int32_t>::min());
  if (header.packed) {
    laz_ = readLazFile(sourceOf(job.bytes), header, job.file);
    count_ = laz_.points;
    return;
  }
  const std::uint64_t size = job.bytes.size();
  const std::uint64_t room =
      header.points_at < size ? (size - header.points_at) / header.record_bytes : 0;
  count_ = std::min(room, header.points);
  bytes_behind_ = (room - count_) * header.record_bytes;
}

void LasRecords::forEachBlock(const Take& take) {
  header_.packed ? givePacked(take) : giveMapped(take);
}

void LasRecords::report(std::uint64_t done) const {
  job_.task.check();
  job_.task.report("reading points", static_cast<double>(done) / static_cast<double>(count_));
}

void LasRecords::giveMapped(const Take& take) const {
  for (std::uint64_t done = 0; done < count_; done += kBlock) {
    report(done);
    take(job_.bytes.data() + header_.points_at + done * header_.record_bytes,
         static_cast<std::size_t>(std::min<std::uint64_t>(kBlock, count_ - done)));
  }
}

void LasRecords::givePacked(const Take& take) {
  Batch done;
  Batch next;
  std::size_t chunk = 0;
  if (laz_.chunks.empty()) return;
  do {
    if (done.empty() && chunk < laz_.chunks.size() &&
        laz_.chunks[chunk].points * header_.record_bytes > kLongChunkBytes) {
      giveLong(chunk++, take);
      continue;
    }
    chunk = planBatch(chunk, next);
    unpackOnAllThreads(next, [&] { give(done, take); });
    std::swap(done, next);
  } while (chunk < laz_.chunks.size() || !done.empty());
}

/// Chunks from `from` on that are unpacked together. @return  the first that is not
std::size_t LasRecords::planBatch(std::size_t from, Batch& batch) const {
  std::uint64_t bytes = 0;
  std::size_t count = 0;
  for (; from < laz_.chunks.size() && count < 4 * threads_; ++from, ++count) {
    const std::uint64_t of_chunk = laz_.chunks[from].points * header_.record_bytes;
    bytes += of_chunk;
    if (of_chunk > kLongChunkBytes || (count > 0 && bytes > kBatchBytes)) break;
    if (count == batch.size()) batch.emplace_back();
    batch[count].chunk = from;
  }
  batch.resize(count);
  return from;
}

/// @param meanwhile  done by this thread before it helps
void LasRecords::unpackOnAllThreads(Batch& batch, const std::function<void()>& meanwhile) const {
  std::atomic<std::size_t> taken{0};
  // A piece that was taken is unpacked, whatever comes: nobody else does it, and what it held
  // before would be given in its place.
  const auto work = [&](const std::stop_token& stop) {
    while (!stop.stop_requested()) {
      const std::size_t i = taken++;
      if (i >= batch.size()) return;
      unpack(batch[i]);
    }
  };
  std::vector<std::jthread> helpers;
  try {
    while (helpers.size() + 1 < std::min(threads_, batch.size())) helpers.emplace_back(work);
  } catch (const std::system_error&) {
    // Fewer threads than cores are allowed here; those that run do the work.
  }
  meanwhile();
  work({});
}

void LasRecords::unpack(Piece& piece) const {
  const LazChunk& chunk = laz_.chunks[piece.chunk];
  const auto points = static_cast<std::size_t>(chunk.points);
  piece.damage.reset();
  piece.seen = {};
  try {
    const auto decoder = openLazChunk(laz_.layout, bytesOf(chunk), chunk.points, wanted_);
    piece.records.resize(points * header_.record_bytes);
    decoder->decode(piece.records.data(), points);
    piece.seen.has_unused_bytes = laz_.has_sizes && decoder->unusedBytes() > kLazSlack;
    look(piece.records.data(), points, piece.seen);
  } catch (const LazDamage& damage) {
    piece.damage = damage;
  }
}

void LasRecords::give(const Batch& batch, const Take& take) {
  for (const Piece& piece : batch) {
    if (piece.damage) refuseLazChunk(job_.file, piece.chunk, *piece.damage);
    const LazChunk& chunk = laz_.chunks[piece.chunk];
    report(chunk.first);
    add(piece.seen);
    take(piece.records.data(), static_cast<std::size_t>(chunk.points));
  }
}

/// A chunk of very many points, block by block.
void LasRecords::giveLong(std::size_t index, const Take& take) {
  const LazChunk& chunk = laz_.chunks[index];
  try {
    const auto decoder = openLazChunk(laz_.layout, bytesOf(chunk), chunk.points, wanted_);
    std::vector<char> records(kBlock * header_.record_bytes);
    for (std::uint64_t done = 0; done < chunk.points; done += kBlock) {
      report(chunk.first + done);
      const auto count =
          static_cast<std::size_t>(std::min<std::uint64_t>(kBlock, chunk.points - done));
      decoder->decode(records.data(), count);
      Seen seen{};
      look(records.data(), count, seen);
      add(seen);
      take(records.data(), count);
    }
    seen_.has_unused_bytes |= laz_.has_sizes && decoder->unusedBytes() > kLazSlack;
  } catch (const LazDamage& damage) {
    refuseLazChunk(job_.file, index, damage);
  }
}

std::string_view LasRecords::bytesOf(const LazChunk& chunk) const {
  return job_.bytes.substr(static_cast<std::size_t>(chunk.at),
                           static_cast<std::size_t>(chunk.bytes));
}

void LasRecords::look(const char* records, std::size_t count, Seen& seen) const {
  const unsigned return_bits = laz_.layout.layered ? 15 : 7;
  seen.least.fill(std::numeric_limits<std::int32_t>::max());
  seen.most.fill(std::numeric_limits<std::int32_t>::min());
  for (std::size_t i = 0; i < count; ++i, records += header_.record_bytes) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto stored = loadAs<std::int32_t>(records + 4 * axis, ByteOrder::little);
      seen.least[axis] = std::min(seen.least[axis], stored);
      seen.most[axis] = std::max(seen.most[axis], stored);
    }
    ++seen.by_return[static_cast<unsigned char>(records[kReturnsAt]) & return_bits];
  }
}

void LasRecords::add(const Seen& seen) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    seen_.least[axis] = std::min(seen_.least[axis], seen.least[axis]);
    seen_.most[axis] = std::max(seen_.most[axis], seen.most[axis]);
  }
  for (std::size_t r = 0; r < seen.by_return.size(); ++r) seen_.by_return[r] += seen.by_return[r];
  seen_.has_unused_bytes |= seen.has_unused_bytes;
}

std::vector<Message> LasRecords::doubts() const {
  std::vector<Message> found;
  if (!header_.packed) return found;
  if (const auto& box = header_.stated_bounds; box && count_ > 0) {
    const std::array<double, 3> low{box->min.x, box->min.y, box->min.z};
    const std::array<double, 3> high{box->max.x, box->max.y, box->max.z};
    bool outside = false;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double step = 1.001 * std::abs(header_.scale[axis]);  // Boxes are rounded.
      for (const std::int32_t stored : {seen_.least[axis], seen_.most[axis]}) {
        const double at = stored * header_.scale[axis] + header_.offset[axis];
        outside |= at < low[axis] - step || at > high[axis] + step;
      }
    }
    if (outside) found.push_back(said<MessageId::laz_points_outside_box>());
  }
  if (const auto stated = statedReturns(job_.bytes, header_); stated && count_ == header_.points) {
    if (!std::equal(stated->begin(), stated->end(), seen_.by_return.begin() + 1)) {
      found.push_back(said<MessageId::laz_other_returns>());
    }
  }
  if (seen_.has_unused_bytes && laz_.has_list) {
    found.push_back(said<MessageId::laz_bytes_behind_points>());
  }
  if (!laz_.has_list) found.push_back(said<MessageId::laz_list_missing>());
  return found;
}

}  // namespace relievo
