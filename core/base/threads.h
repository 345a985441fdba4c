// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>

namespace relievo {

inline constexpr int kMostThreads = 64;  ///< Each has bands of its own in memory.

/// @param wanted  0: as many as there are cores for this process; else exactly these
int threadCount(int wanted);

/// Calls work(part, first, end) for `threads` parts of first ... end, one of them on this thread,
/// and waits for all. What `work` throws on any thread is thrown here.
void inParts(std::uint64_t first, std::uint64_t end, int threads,
             const std::function<void(int part, std::uint64_t first, std::uint64_t end)>& work);

/// Makes pieces 0 ... count - 1 on `threads` threads, `threads` at a time, and takes each in order
/// on this one. @param make  runs for different pieces at once
void orderedPipeline(int count, int threads, const std::function<void(int place, int piece)>& make,
                     const std::function<void(int place, int piece)>& take);

}  // namespace relievo
