// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/io/las/las_header.h"
#include "core/io/las/laz_file.h"
#include "core/io/read_scan.h"
#include "core/message/message.h"

namespace relievo {

/// The records of a LAS, LAZ or COPC file in memory, as LAS stores them, in the file's order.
class LasRecords {
 public:
  /// @param wanted   fields that need not be unpacked keep the value of a chunk's first point
  /// @param threads  that unpack; 0: one for each core. The records are the same for any number.
  /// @throw FileError  a packed file is damaged
  explicit LasRecords(const ReadJob& job, const LasHeader& header, const LazWanted& wanted = {},
                      int threads = 0);

  /// Complete records; fewer than the header promises only where the file is cut.
  std::uint64_t count() const noexcept { return count_; }

  /// Bytes of a file that is not packed, behind the records.
  std::uint64_t bytesBehind() const noexcept { return bytes_behind_; }

  using Take = std::function<void(const char* records, std::size_t count)>;
  /// Calls take() on this thread for all records in blocks. [worker]
  /// @throw FileError  packed points are damaged; Cancelled
  void forEachBlock(const Take& take);

  /// What points to damage in a packed file that was unpacked without contradiction, in sentences:
  /// such files hold no checksum. To be asked after the records were given.
  std::vector<Message> doubts() const;

 private:
  /// What is seen of records while they are unpacked.
  struct Seen {
    std::array<std::int32_t, 3> least, most;
    std::array<std::uint64_t, 16> by_return;
    bool has_unused_bytes;
  };
  /// A chunk's records.
  struct Piece {
    std::size_t chunk;
    std::vector<char> records;
    Seen seen;
    std::optional<LazDamage> damage;
  };
  using Batch = std::vector<Piece>;

  void giveMapped(const Take& take) const;
  void givePacked(const Take& take);
  void giveLong(std::size_t chunk, const Take& take);
  std::size_t planBatch(std::size_t from, Batch& batch) const;
  void unpackOnAllThreads(Batch& batch, const std::function<void()>& meanwhile) const;
  void unpack(Piece& piece) const;
  void give(const Batch& batch, const Take& take);
  std::string_view bytesOf(const LazChunk& chunk) const;
  void look(const char* records, std::size_t count, Seen& seen) const;
  void add(const Seen& seen);
  void report(std::uint64_t done) const;

  const ReadJob& job_;
  const LasHeader& header_;
  LazWanted wanted_;
  std::size_t threads_;
  std::uint64_t count_ = 0, bytes_behind_ = 0;
  LazFile laz_;
  Seen seen_;
};

}  // namespace relievo
