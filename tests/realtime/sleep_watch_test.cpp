// SPDX-License-Identifier: BSD-3-Clause
// Sleep as a program meets it: a bus of the test's own with a logind that tells of it.
#include "haptics/rt/sleep_watch.h"

#include <gtest/gtest.h>

#include <chrono>
#include <functional>

#include "haptics/rt/realtime_thread.h"
#include "tests/realtime/fake_logind.h"

namespace relievo {
namespace {

using News = SleepWatch::News;
using test::FakeLogind;

bool eventually(const std::function<bool()>& holds) {
  const std::int64_t give_up = monotonicNs() + 60'000'000'000;
  while (!holds()) {
    if (monotonicNs() > give_up) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return true;
}

class SleepWatchTest : public test::BusTest {
 protected:
  static bool comes(SleepWatch& watch, News news) {
    return eventually([&] { return watch.poll() == news; });
  }
  /// The lock is given and taken; on the way nothing is told.
  static bool isReady(SleepWatch& watch) {
    return eventually([&] { return watch.poll() == News::none && watch.delays(); });
  }
};

TEST_F(SleepWatchTest, SleepWaitsUntilAllIsAtZero) {
  FakeLogind logind(bus_->address());
  SleepWatch watch;
  ASSERT_TRUE(isReady(watch)) << watch.note();
  EXPECT_EQ(logind.askedFor(), "sleep, delay");
  EXPECT_TRUE(logind.isDelayed());
  logind.tell(true);
  ASSERT_TRUE(comes(watch, News::about_to_sleep));
  EXPECT_TRUE(logind.isDelayed()) << "not before we say so";
  watch.letSleep();
  EXPECT_FALSE(logind.isDelayed());
  logind.tell(false);
  ASSERT_TRUE(comes(watch, News::woken));
  ASSERT_TRUE(isReady(watch)) << "the next sleep waits as well";
  EXPECT_TRUE(logind.isDelayed());
  EXPECT_EQ(logind.locksGiven(), 2);
}

TEST_F(SleepWatchTest, NobodyIsDelayedByAProgramThatHasEnded) {
  FakeLogind logind(bus_->address());
  {
    SleepWatch watch;
    ASSERT_TRUE(isReady(watch));
  }
  // The bus may still hold the lock that it has just handed over.
  EXPECT_TRUE(eventually([&] { return !logind.isDelayed(); }));
}

TEST_F(SleepWatchTest, ARefusalIsToldInItsWordsAndSleepIsToldAllTheSame) {
  FakeLogind logind(bus_->address(), false);
  SleepWatch watch;
  ASSERT_TRUE(eventually([&] { return watch.poll() == News::none && !watch.note().empty(); }));
  EXPECT_EQ(watch.note(), "not for you");
  EXPECT_FALSE(watch.delays());
  logind.tell(true);
  EXPECT_TRUE(comes(watch, News::about_to_sleep));
}

TEST_F(SleepWatchTest, ABusWithoutLogindIsSaidAndTellsNothing) {
  SleepWatch watch;
  ASSERT_TRUE(eventually([&] { return watch.poll() == News::none && !watch.note().empty(); }));
  EXPECT_NE(watch.note().find("login1"), std::string::npos) << watch.note();
}

}  // namespace
}  // namespace relievo
