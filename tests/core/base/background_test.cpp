// SPDX-License-Identifier: BSD-3-Clause
#include "core/base/background.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <thread>

namespace relievo {
namespace {

int niceness() {
  return ::getpriority(PRIO_PROCESS, 0);
}

TEST(Background, IsOfTheThreadAndOfWhatItStarts) {
  const int before = niceness();
  if (before >= 5) GTEST_SKIP() << "this process already runs in the background";
  int own = 0, started = 0;
  std::thread([&] {
    workInBackground();
    own = niceness();
    std::thread([&] { started = niceness(); }).join();
  }).join();
  EXPECT_EQ(own, 5);
  EXPECT_EQ(started, 5);
  EXPECT_EQ(niceness(), before) << "nobody else";
}

TEST(Background, NeverRaises) {
  int own = 0;
  std::thread([&] {
    ::setpriority(PRIO_PROCESS, 0, 15);
    workInBackground();
    own = niceness();
  }).join();
  EXPECT_EQ(own, 15);
}

}  // namespace
}  // namespace relievo
