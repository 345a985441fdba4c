// SPDX-License-Identifier: BSD-3-Clause
// What PointStream and its import process agree on.
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/base/transform.h"
#include "core/io/point_stream.h"

namespace relievo {

/// A channel is a socket at kFirstChannelFd + its number in the process; behind the last of them
/// is a file in memory with a slice for each. A request is answered before the next is sent.
inline constexpr int kMostChannels = 4;
/// What fits into a slice: PointStream's callers ask for no more at once.
inline constexpr std::size_t kPointsAtOnce = 16384;
inline constexpr std::size_t kSliceBytes =
    kPointsAtOnce * (sizeof(FilePoint) + sizeof(StoredValues));
/// More than the chunks of any file that this version reads.
inline constexpr std::size_t kMostSampleRanges = std::size_t{1} << 22U;
inline constexpr std::size_t kRangesAtOnce = kSliceBytes / sizeof(PointRange);

enum class StreamAsk : std::uint64_t {
  points,        ///< `count` from `first` on.
  values,        ///< The same; then, behind the room for all points, what is stored beside them.
  ranges,        ///< Of `count` ranges, which the slice holds.
  cheap_sample,  ///< Of `count` points; ranges from the `first` on, as many as fit.
};

struct StreamRequest {
  StreamAsk ask = StreamAsk::points;
  std::uint64_t first = 0, count = 0;
};

struct StreamReply {
  std::uint64_t refused = 0;  ///< 1: the slice holds a WorkerRefusal of `count` bytes.
  std::uint64_t count = 0;    ///< Points, or ranges.
};

/// The first thing on channel 0 from the process: its answer is there. Then, to the process:
struct StreamStart {
  double height_factor = 1;  ///< PointReader::convertHeights.
};

}  // namespace relievo
