// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <barrier>
#include <cstddef>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "core/base/exchange.h"

namespace relievo::test {

/// Where threads meet that work as if each were a process.
struct MeetingPlace {
  explicit MeetingPlace(int ranks) : told(static_cast<std::size_t>(ranks)), all(ranks) {}
  std::vector<std::string> told;
  std::barrier<> all;
};

class ThreadExchange : public Exchange {
 public:
  ThreadExchange(MeetingPlace& place, int rank)
      : Exchange(rank, static_cast<int>(place.told.size())), place_(place) {}

 private:
  std::vector<std::string> gather(const std::string& mine) override {
    place_.told[static_cast<std::size_t>(rank())] = mine;
    place_.all.arrive_and_wait();
    std::vector<std::string> told = place_.told;
    place_.all.arrive_and_wait();
    return told;
  }

  MeetingPlace& place_;
};

/// Runs `work` in so many threads at once; it throws nothing.
inline void inThreads(int ranks, const std::function<void(Exchange&)>& work) {
  MeetingPlace place(ranks);
  std::vector<std::jthread> threads;
  threads.reserve(static_cast<std::size_t>(ranks));
  for (int rank = 0; rank < ranks; ++rank) {
    threads.emplace_back([&place, &work, rank] {
      ThreadExchange exchange(place, rank);
      work(exchange);
    });
  }
}

}  // namespace relievo::test
