// SPDX-License-Identifier: BSD-3-Clause
// The hierarchy of COPC 1.0: pages of nodes, each a chunk of points at some level of an octree.
#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/io/formats/scalar.h"
#include "core/io/las/laz_file.h"
#include "core/io/read_scan.h"
#include "core/message/catalogue.h"

namespace relievo {
namespace {

constexpr std::size_t kEntryBytes = 32;
constexpr std::uint64_t kMostPageBytes = 64U << 20U;
constexpr int kMostLevels = 30;  ///< Places of nodes are signed numbers of 32 bits.

[[noreturn]] void refuse(const std::filesystem::path& file, Message what) {
  throwReadError(file, said<MessageId::refused_copc>(std::move(what)),
                 said<MessageId::advice_damaged_copy>());
}

struct Entry {
  std::int32_t level, x, y, z;
  std::uint64_t at;
  std::int32_t bytes, points;  ///< Points -1: the bytes are a further page.
};

Entry entryAt(const char* at) {
  const auto number = [at](std::size_t i) {
    return loadAs<std::int32_t>(at + 4 * i, ByteOrder::little);
  };
  return {
      number(0), number(1), number(2), number(3), loadAs<std::uint64_t>(at + 16, ByteOrder::little),
      number(6), number(7)};
}

class Hierarchy {
 public:
  Hierarchy(const LazBytesSource& source, LazFile& laz, const std::filesystem::path& file)
      : source_(source), laz_(laz), file_(file) {}

  /// @param at  of the root page  @param bytes  of it
  void read(std::uint64_t at, std::uint64_t bytes) {
    addPage(at, bytes);
    while (!pages_.empty()) {
      const Page page = pages_.back();
      pages_.pop_back();
      const std::string entries = source_.read(page.at, page.bytes);
      for (std::size_t i = 0; i + kEntryBytes <= entries.size(); i += kEntryBytes) {
        addEntry(entryAt(entries.data() + i));
      }
    }
    if (std::any_of(laz_.chunks.begin(), laz_.chunks.end(),
                    [](const LazChunk& chunk) { return chunk.level < 0; })) {
      refuse(file_, said<MessageId::copc_leaves_out>());
    }
  }

 private:
  struct Page {
    std::uint64_t at, bytes;
  };

  void addPage(std::uint64_t at, std::uint64_t bytes) {
    if (bytes == 0 || bytes % kEntryBytes != 0 || bytes > kMostPageBytes || bytes > source_.size ||
        at > source_.size - bytes) {
      refuse(file_, said<MessageId::copc_page_outside>());
    }
    if (!seen_.insert(at).second) refuse(file_, said<MessageId::copc_circle>());
    // Pages do not overlap, so that together they are no longer than the file.
    page_bytes_ += bytes;
    if (page_bytes_ > source_.size) refuse(file_, said<MessageId::copc_circle>());
    pages_.push_back({at, bytes});
  }

  void addEntry(const Entry& entry) {
    const bool has_place = entry.level >= 0 && entry.level <= kMostLevels;
    const auto inside = [&entry](std::int32_t key) { return key >= 0 && key >> entry.level == 0; };
    if (!has_place || !inside(entry.x) || !inside(entry.y) || !inside(entry.z)) {
      refuse(file_, said<MessageId::copc_node_outside>());
    }
    if (entry.points == -1) {
      addPage(entry.at, static_cast<std::uint64_t>(std::max(entry.bytes, 0)));
    } else if (entry.points != 0) {
      addChunk(entry);
    }
  }

  void addChunk(const Entry& entry) {
    const auto chunk =
        std::lower_bound(laz_.chunks.begin(), laz_.chunks.end(), entry.at,
                         [](const LazChunk& c, std::uint64_t at) { return c.at < at; });
    const bool is_one = chunk != laz_.chunks.end() && chunk->at == entry.at && entry.points > 0 &&
                        chunk->points == static_cast<std::uint64_t>(entry.points) &&
                        chunk->bytes == static_cast<std::uint64_t>(std::max(entry.bytes, 0));
    if (!is_one) refuse(file_, said<MessageId::copc_no_block>());
    if (chunk->level >= 0) refuse(file_, said<MessageId::copc_block_twice>());
    chunk->level = entry.level;
  }

  const LazBytesSource& source_;
  LazFile& laz_;
  const std::filesystem::path& file_;
  std::vector<Page> pages_;
  std::set<std::uint64_t> seen_;
  std::uint64_t page_bytes_ = 0;
};

}  // namespace

void readCopcLevels(const LazBytesSource& source, std::string_view root, LazFile& laz,
                    const std::filesystem::path& file) {
  constexpr std::size_t kRootAt = 40;  // Behind the cube and its spacing.
  if (root.size() < kRootAt + 16) refuse(file, said<MessageId::copc_without_root>());
  laz.is_copc = true;
  Hierarchy(source, laz, file)
      .read(loadAs<std::uint64_t>(root.data() + kRootAt, ByteOrder::little),
            loadAs<std::uint64_t>(root.data() + kRootAt + 8, ByteOrder::little));
}

}  // namespace relievo
