// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <vector>

#include "core/base/task.h"
#include "core/io/las/laz_file.h"

namespace relievo {

/// Points `first` ... `first + count - 1` of a file.
struct PointRange {
  std::uint64_t first = 0, count = 0;
  friend bool operator==(const PointRange&, const PointRange&) = default;
};

/// What is unpacked of records, and how much of their beginning is given.
struct LazKept {
  std::size_t bytes = 0;
  LazWanted wanted;
};

/// Any points of a LAZ or COPC file by their number, unpacked when they are asked for. The last few
/// chunks are kept for each thread that reads, at most 32 MB or one chunk.
class LazPoints {
 public:
  /// @param task        whose stop token every read looks at
  /// @throw FileError  chunks are too long to be unpacked for a few of their points
  LazPoints(LazBytesSource source, LazFile laz, std::filesystem::path file, const LazKept& kept,
            const Task& task);
  ~LazPoints();

  /// Writes the first bytes of `count` records to `out`. [any thread]
  /// @throw FileError  they are damaged; Cancelled
  void read(std::uint64_t first, std::size_t count, char* out) const;

  /// What one reading thread keeps at most, for its next block. [any thread]
  std::size_t keptBytes() const noexcept;

  /// About `wanted` points that are had without unpacking much else: of COPC the coarsest levels
  /// that together are no more, else the beginning of each chunk. In the file's order.
  std::vector<PointRange> cheapSample(std::uint64_t wanted) const;

 private:
  /// A chunk as far as it is unpacked.
  struct OpenChunk {
    std::size_t index = 0;
    std::unique_ptr<const std::string> bytes;  ///< Where they are, for the decoder.
    std::unique_ptr<LazChunkDecoder> decoder;  ///< Null once all is unpacked.
    std::vector<char> kept;
  };
  /// What one thread at a time uses; the chunk used last comes first.
  using Reader = std::vector<OpenChunk>;

  std::unique_ptr<Reader> takeReader(std::size_t chunk) const;
  OpenChunk& open(Reader& reader, std::size_t chunk) const;
  void unpack(OpenChunk& chunk, std::uint64_t points) const;

  LazBytesSource source_;
  LazFile laz_;
  std::filesystem::path file_;
  std::size_t kept_bytes_;
  LazWanted wanted_;
  Task task_;                 ///< Stops, but tells no progress.
  mutable std::mutex mutex_;  ///< Held to take a reader and to put it back, never to unpack.
  mutable std::vector<std::unique_ptr<Reader>> readers_;  ///< Those that nobody uses now.
};

}  // namespace relievo
