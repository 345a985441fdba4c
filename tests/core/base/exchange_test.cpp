// SPDX-License-Identifier: BSD-3-Clause
// What processes that make one map together tell each other, and how all end when one does.
#include "core/base/exchange.h"

#include <gtest/gtest.h>

#include <atomic>
#include <mutex>

#include "tests/core/base/thread_exchange.h"

namespace relievo {
namespace {

TEST(Exchange, GivesEverybodyWhatEachSaidByRank) {
  std::atomic<int> right = 0;
  test::inThreads(3, [&](Exchange& exchange) {
    const std::string mine(static_cast<std::size_t>(exchange.rank()), 'x');  // The first: nothing.
    right += exchange.share(mine) == std::vector<std::string>{"", "x", "xx"} ? 1 : 0;
    exchange.finish();
    // A byte of whether one goes on and the text, to each of two others; finish() likewise.
    right += exchange.sentBytes() == 2 * (3 + 3) + 2 * 3 ? 1 : 0;
  });
  EXPECT_EQ(right, 6);
}

TEST(Exchange, EndsAllWithTheFirstReason) {
  std::atomic<int> ended = 0;
  std::mutex lock;
  std::vector<Exchange::Stopped> reasons;
  test::inThreads(4, [&](Exchange& exchange) {
    exchange.wait();
    if (exchange.rank() % 2 == 1) {
      exchange.stop(exchange.rank() + 1, "no room on " + std::to_string(exchange.rank()));
    } else {
      EXPECT_THROW(exchange.wait(), OtherProcessStopped);
    }
    ++ended;
    exchange.stop(9, "too late: nobody listens");
    const std::lock_guard one_at_a_time(lock);
    if (exchange.stopped()) reasons.push_back(*exchange.stopped());
  });
  EXPECT_EQ(ended, 4);
  ASSERT_EQ(reasons.size(), 4U);
  for (const Exchange::Stopped& reason : reasons) {
    EXPECT_EQ(reason.rank, 1);
    EXPECT_EQ(reason.exit_code, 2);
    EXPECT_EQ(reason.sentence, "no room on 1");
  }
}

TEST(Exchange, AfterTheEndNobodyWaitsForWhoStops) {
  test::inThreads(2, [](Exchange& exchange) {
    exchange.finish();
    if (exchange.isFirst()) exchange.stop(3, "The report could not be written.");
    EXPECT_FALSE(exchange.stopped());
  });
}

TEST(Exchange, EveryPieceHasOneProcess) {
  for (const int pieces : {0, 1, 2, 7, 100'000}) {
    std::mutex lock;
    std::vector<std::pair<int, int>> parts(5);
    test::inThreads(5, [&](Exchange& exchange) {
      const std::lock_guard one_at_a_time(lock);
      parts[static_cast<std::size_t>(exchange.rank())] = exchange.partOf(pieces);
    });
    int next = 0;
    for (const auto& [first, end] : parts) {
      EXPECT_EQ(first, next);
      EXPECT_NEAR(end - first, pieces / 5.0, 1);
      next = end;
    }
    EXPECT_EQ(next, pieces);
  }
}

}  // namespace
}  // namespace relievo
