// SPDX-License-Identifier: BSD-3-Clause
// What WebLink and its process agree on: requests and answers over one socket, in any order.
#pragma once

#include <cstdint>

namespace relievo {

enum class WebAsk : std::uint32_t {
  bytes,      ///< `count` bytes from `first` on, as they are; a count of 0: the whole file.
  tile,       ///< The same, unpacked: `part` says how.
  published,  ///< The whole file, a PublishedMap: its bytes and then what it says.
};

enum class WebEnd : std::uint32_t {
  good,
  unreachable,  ///< No answer, or one that may be another next time.
  missing,      ///< The server answers that there is no such file, or that nobody may read it.
  damaged,      ///< It is not what was asked for.
  ended,        ///< The process has ended. Said by WebLink itself.
};

struct WebRequest {
  std::uint64_t id = 0, first = 0;
  WebAsk ask = WebAsk::bytes;
  std::uint32_t count = 0, part = 0, name_bytes = 0;  ///< The name follows.
};

struct WebReply {
  std::uint64_t id = 0;
  WebEnd end = WebEnd::good;
  std::uint32_t bytes = 0;  ///< They follow; what is wrong in words, if it is not good.
};

inline constexpr int kWebConnections = 8;
inline constexpr std::uint32_t kMostWebName = 8192;
inline constexpr std::uint64_t kMostWebBytes = std::uint64_t{1} << 30U;  ///< Of one answer.

}  // namespace relievo
