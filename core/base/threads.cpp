// SPDX-License-Identifier: BSD-3-Clause
#include "core/base/threads.h"

#include <algorithm>

#include "core/base/bands.h"
#include "core/base/control_group.h"

namespace relievo {

int threadCount(int wanted) {
  static const int cores = std::min(usableCores(), kMostThreads);
  return wanted > 0 ? wanted : cores;
}

void inParts(std::uint64_t first, std::uint64_t end, int threads,
             const std::function<void(int part, std::uint64_t first, std::uint64_t end)>& work) {
  const auto parts = static_cast<std::uint64_t>(std::max(threads, 1));
  const auto edge = [&](int i) {
    return first + (end - first) * static_cast<std::uint64_t>(i) / parts;
  };
  parallelFor(threads, threads, [&](int begin, int last) {
    for (int part = begin; part < last; ++part) {
      if (edge(part) < edge(part + 1)) work(part, edge(part), edge(part + 1));
    }
  });
}

void orderedPipeline(int count, int threads, const std::function<void(int place, int piece)>& make,
                     const std::function<void(int place, int piece)>& take) {
  for (int first = 0; first < count; first += threads) {
    const int together = std::min(threads, count - first);
    parallelFor(together, together, [&](int begin, int end) {
      for (int place = begin; place < end; ++place) make(place, first + place);
    });
    for (int place = 0; place < together; ++place) take(place, first + place);
  }
}

}  // namespace relievo
