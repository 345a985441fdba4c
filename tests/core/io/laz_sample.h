// SPDX-License-Identifier: BSD-3-Clause
// LAZ and COPC files for tests, and LAS files of the same records.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "tests/core/io/las_sample.h"
#include "tests/core/io/laz_encoder.h"

namespace relievo::test {

using Records = std::vector<std::string>;

/// Full waveforms that follow each other, now and then elsewhere.
class WanderingWaves {
 public:
  std::string next(std::mt19937& random) {
    const auto below = [&random](std::uint32_t n) {
      return static_cast<std::uint32_t>(random() % n);
    };
    const std::uint32_t way = below(10);
    if (way < 5) place_ += size_;
    if (way == 5) place_ += below(100'000) - 50'000ULL;
    if (way == 6) place_ = std::uint64_t{random()} << 32U | random();
    if (below(10) == 0) size_ = 100 + below(50);
    if (below(20) == 0) descriptor_ = static_cast<char>(below(256));
    for (float& direction : directions_) direction += 1e-6F * static_cast<float>(below(100));
    std::string bytes = std::string(1, descriptor_) + bytesOf(place_) + bytesOf(size_);
    for (const float direction : directions_) bytes += bytesOf(direction);
    return bytes;
  }

 private:
  char descriptor_ = 1;
  std::uint64_t place_ = 60;
  std::uint32_t size_ = 128;
  std::array<float, 4> directions_{12.5F, 1e-4F, 2e-4F, -3e-4F};
};

/// Points of a scan that wanders on, now finely, now in leaps, with all fields in use.
/// @param wild  some points lie anywhere, and some returns cannot be
inline Records wanderingRecords(const Packing& how, std::size_t count, unsigned channels = 1,
                                unsigned seed = 1, bool wild = true) {
  std::mt19937 random(seed);
  const auto below = [&random](std::uint32_t n) {
    return static_cast<std::uint32_t>(random() % n);
  };
  const auto rarely = [&](std::uint32_t percent) { return below(100) < percent; };
  std::array<std::uint32_t, 3> place{1000, 2000, 3000};
  std::array<std::uint16_t, 4> colour{1000, 2000, 3000, 400};
  std::uint32_t mode = 0, channel = 0, flags = 0, kind = 1, user = 0, angle = 0, source = 7;
  std::uint16_t grey = 100;
  double time = 1e5;
  std::string extra(how.extra_bytes, '\1');
  WanderingWaves waves;
  Records records;
  for (std::size_t i = 0; i < count; ++i) {
    if (rarely(3)) mode = below(4);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      place[axis] += below(axis == 2 ? 7 : 40) * (mode == 3 ? below(1000) : 1) - 3;
    }
    if (wild && mode == 3 && rarely(10)) place[below(3)] = static_cast<std::uint32_t>(random());
    constexpr std::array<double, 4> kSteps{1e-5, 1e-4, 3e-3, 1e3};
    if (!rarely(40))
      time += kSteps[mode] * (1 + (mode > 1 ? below(2000) : 0)) * (rarely(5) ? -1 : 1);
    if (rarely(1)) time = below(1000) * 1e6;
    if (rarely(50)) grey = static_cast<std::uint16_t>(rarely(5) ? random() : grey + below(9) - 4);
    for (std::uint16_t& c : colour) {
      if (rarely(30)) c = static_cast<std::uint16_t>(c + below(600) - 300);
    }
    if (rarely(10)) colour[1] = colour[2] = colour[0];
    for (std::uint32_t* const field : {&flags, &kind, &user, &angle, &source}) {
      if (rarely(5)) *field = static_cast<std::uint32_t>(random());
    }
    if (channels > 1 && rarely(20)) channel = below(channels);
    for (std::size_t e = 0; e < extra.size(); ++e) {
      if (e != 1 && rarely(30))
        extra[e] = static_cast<char>(extra[e] + static_cast<char>(below(3)));
    }
    std::string record;
    for (const std::uint32_t coordinate : place) record += bytesOf(coordinate);
    record += bytesOf(grey);
    const std::uint32_t most = how.format >= 6 ? 15 : 7;
    const std::uint32_t n = wild && rarely(10) ? below(most + 1) : 1 + below(3);
    const std::uint32_t r = wild && rarely(10) ? below(most + 1) : 1 + below(std::max(n, 1U));
    const auto byte = [](std::uint32_t value) { return std::string(1, static_cast<char>(value)); };
    if (how.format >= 6) {
      record += byte(r | n << 4U) + byte((flags & 0xCFU) | channel << 4U) + byte(kind) +
                byte(user) + bytesOf(static_cast<std::uint16_t>(angle)) +
                bytesOf(static_cast<std::uint16_t>(source)) + bytesOf(time);
    } else {
      record += byte(r | n << 3U | (flags & 0xC0U)) + byte(kind) + byte(angle) + byte(user) +
                bytesOf(static_cast<std::uint16_t>(source));
      if (how.timed()) record += bytesOf(time);
    }
    for (std::size_t c = 0; c < how.colourBytes() / 2; ++c) record += bytesOf(colour[c]);
    if (how.waved()) record += waves.next(random);
    records.push_back(record + extra);
  }
  return records;
}

struct Laz {
  Packing how;
  Records records;
  std::uint32_t chunk_points = 50'000;  ///< All ones: as `chunks` says.
  std::vector<std::size_t> chunks;      ///< Points of each, where they are of any number.
  bool one_stream = false;              ///< Compressor 1: no chunks at all.
  std::vector<int> levels;              ///< Of each chunk: makes it a COPC file.
  double scale = 0.01;
  std::size_t padding = 0;  ///< Bytes behind each chunk that nothing needs.
  bool states_box = true;
};

/// A file, and where its parts are, to break them.
struct LazBytes {
  std::string bytes;
  std::size_t packing_at = 0;  ///< Contents of the record "laszip encoded".
  std::size_t points_at = 0;
  std::vector<std::size_t> chunks_at;
  std::size_t table_at = 0;
  std::size_t root_at = 0, child_at = 0;  ///< Pages of COPC, entries of 32 bytes.
};

inline std::string lazRecord(const std::string& owner, std::uint16_t number,
                             const std::string& content) {
  std::string user = owner;
  user.resize(16, '\0');
  return bytesOf(std::uint16_t{0}) + user + bytesOf(number) +
         bytesOf(static_cast<std::uint16_t>(content.size())) + std::string(32, '\0') + content;
}

inline std::string packingRecord(const Laz& laz) {
  struct Item {
    std::uint16_t kind, bytes;
    int version;
  };
  const Packing& how = laz.how;
  const bool layered = how.layered();
  const auto extra = static_cast<std::uint16_t>(how.extra_bytes);
  const int version = layered ? how.version : how.version == 1 ? 1 : 2;
  std::vector<Item> items{layered ? Item{10, 30, version} : Item{6, 20, version}};
  if (how.timed()) items.push_back({7, 8, version});
  if (how.infrared()) {
    items.push_back({12, 8, version});
  } else if (how.coloured()) {
    items.push_back({static_cast<std::uint16_t>(layered ? 11 : 8), 6, version});
  }
  if (how.waved()) {
    items.push_back(layered ? Item{13, 29, version} : Item{9, 29, 1});
  }
  if (extra > 0) items.push_back({static_cast<std::uint16_t>(layered ? 14 : 0), extra, version});
  std::string content = bytesOf(static_cast<std::uint16_t>(layered          ? 3
                                                           : laz.one_stream ? 1
                                                                            : 2)) +
                        bytesOf(std::uint16_t{0}) + "\3\4" + bytesOf(std::uint16_t{0}) +
                        bytesOf(0U) + bytesOf(laz.chunk_points) + std::string(16, '\xFF') +
                        bytesOf(static_cast<std::uint16_t>(items.size()));
  for (const Item& item : items) {
    content += bytesOf(item.kind) + bytesOf(item.bytes) +
               bytesOf(static_cast<std::uint16_t>(item.version));
  }
  return content;
}

/// Header of LAS, packed or not. @param records  all variable length records
inline std::string headerOf(const Laz& laz, const std::string& records, std::uint32_t record_count,
                            bool packed) {
  Las las;
  las.minor = laz.how.format >= 6 ? 4 : 2;
  las.format = laz.how.format;
  las.count = 0;
  las.extra_bytes = static_cast<int>(laz.how.extra_bytes);
  las.promised = laz.records.size();
  las.legacy_promised = static_cast<std::uint32_t>(laz.records.size());
  las.scale.fill(laz.scale);
  las.variable_records = records;
  las.variable_count = record_count;
  std::string header = lasFile(las);
  if (packed) header[104] = static_cast<char>(header[104] | '\x80');
  const bool layered = laz.how.format >= 6;
  std::array<std::int32_t, 3> least{}, most{};
  least.fill(std::numeric_limits<std::int32_t>::max());
  most.fill(std::numeric_limits<std::int32_t>::min());
  std::array<std::uint64_t, 16> returns{};
  for (const std::string& record : laz.records) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto at = numberOf<std::int32_t>(record.data() + 4 * axis);
      least[axis] = std::min(least[axis], at);
      most[axis] = std::max(most[axis], at);
    }
    ++returns[byteAt(record.data() + 14) & (layered ? 15U : 7U)];
  }
  const auto put = [&header](std::size_t at, const std::string& value) {
    header.replace(at, value.size(), value);
  };
  for (std::size_t axis = 0; axis < 3 && laz.states_box; ++axis) {
    put(179 + 16 * axis, bytesOf(most[axis] * laz.scale));
    put(187 + 16 * axis, bytesOf(least[axis] * laz.scale));
  }
  for (std::size_t r = 1; r <= 5; ++r) {
    put(107 + 4 * r, bytesOf(static_cast<std::uint32_t>(returns[r])));
  }
  for (std::size_t r = 1; r <= 15 && layered; ++r) put(247 + 8 * r, bytesOf(returns[r]));
  return header;
}

inline std::string lasOf(const Laz& laz) {
  std::string bytes = headerOf(laz, "", 0, false);
  for (const std::string& record : laz.records) bytes += record;
  return bytes;
}

/// Two pages: a root with levels 0 and 1, and what is finer.
inline void addHierarchy(const Laz& laz, const std::vector<std::string>& chunks,
                         const std::vector<std::size_t>& points, LazBytes& made) {
  std::string root, child;
  std::vector<std::int32_t> nodes(32, 0);
  for (std::size_t i = 0; i < chunks.size(); ++i) {
    const std::int32_t level = laz.levels[i];
    const std::int32_t place = nodes[static_cast<std::size_t>(level)]++;
    const std::int32_t side = std::int32_t{1} << level;
    std::string& page = level < 2 ? root : child;
    page += bytesOf(level) + bytesOf(place % side) + bytesOf(place / side) + bytesOf(0) +
            bytesOf(std::uint64_t{made.chunks_at[i]}) +
            bytesOf(static_cast<std::int32_t>(chunks[i].size())) +
            bytesOf(static_cast<std::int32_t>(points[i]));
  }
  made.child_at = made.bytes.size();
  made.bytes += child;
  if (!child.empty()) {
    root += bytesOf(2) + bytesOf(0) + bytesOf(0) + bytesOf(0) +
            bytesOf(std::uint64_t{made.child_at}) +
            bytesOf(static_cast<std::int32_t>(child.size())) + bytesOf(-1);
  }
  made.root_at = made.bytes.size();
  made.bytes += root;
  constexpr std::size_t kInfoAt = 375 + 54 + 40;
  const std::string place =
      bytesOf(std::uint64_t{made.root_at}) + bytesOf(std::uint64_t{root.size()});
  made.bytes.replace(kInfoAt, place.size(), place);
}

inline LazBytes lazFile(const Laz& laz) {
  std::string records;
  std::uint32_t record_count = 1;
  if (!laz.levels.empty()) {
    records = lazRecord("copc", 1, std::string(160, '\0'));
    ++record_count;
  }
  const std::string packing = packingRecord(laz);
  records += lazRecord("laszip encoded", 22204, packing);
  LazBytes made;
  made.bytes = headerOf(laz, records, record_count, true);
  made.points_at = made.bytes.size();
  made.packing_at = made.points_at - packing.size();
  if (laz.one_stream) {
    made.bytes += encodeChunk(laz.records, laz.how);
    return made;
  }
  std::vector<std::size_t> points = laz.chunks;
  for (std::size_t done = 0; laz.chunks.empty() && done < laz.records.size();) {
    points.push_back(std::min<std::size_t>(laz.chunk_points, laz.records.size() - done));
    done += points.back();
  }
  made.bytes += std::string(8, '\0');
  std::vector<std::string> chunks;
  auto at = laz.records.begin();
  for (const std::size_t count : points) {
    made.chunks_at.push_back(made.bytes.size());
    const auto end = at + static_cast<std::ptrdiff_t>(count);
    chunks.push_back(encodeChunk({at, end}, laz.how));
    chunks.back().append(laz.padding, '\0');
    made.bytes += chunks.back();
    at = end;
  }
  made.table_at = made.bytes.size();
  made.bytes.replace(made.points_at, 8, bytesOf(std::uint64_t{made.table_at}));
  ArithmeticCoder coder;
  IntegerCoder numbers(32, 2);
  std::array<std::uint32_t, 2> last{};
  const auto add = [&](std::size_t context, std::size_t number) {
    numbers.code(coder, last[context], static_cast<std::uint32_t>(number), context);
    last[context] = static_cast<std::uint32_t>(number);
  };
  for (std::size_t i = 0; i < chunks.size(); ++i) {
    if (!laz.chunks.empty()) add(0, points[i]);
    add(1, chunks[i].size());
  }
  made.bytes += bytesOf(0U) + bytesOf(static_cast<std::uint32_t>(chunks.size()));
  made.bytes += coder.finishAlways();
  if (!laz.levels.empty()) addHierarchy(laz, chunks, points, made);
  return made;
}

}  // namespace relievo::test
