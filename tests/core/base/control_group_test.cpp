// SPDX-License-Identifier: BSD-3-Clause
#include "core/base/control_group.h"

#include <gtest/gtest.h>
#include <sched.h>

#include <algorithm>
#include <fstream>
#include <string>
#include <thread>

#include "tests/core/io/temporary_folder.h"

namespace relievo {
namespace {

/// A made /proc and /sys.
class UsableCores : public ::testing::Test {
 protected:
  void put(const std::string& name, const std::string& text) {
    const std::filesystem::path file = root_.path() / name;
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file) << text;
  }
  int cores() const { return usableCores(root_.path()); }
  /// Without any group.
  int bound() const {
    const test::TemporaryFolder nothing;
    return usableCores(nothing.path());
  }

 private:
  test::TemporaryFolder root_;
};

TEST_F(UsableCores, AreThoseThatTheProcessIsBoundTo) {
  EXPECT_GE(bound(), 1);
  int with_one = 0;
  std::thread([&] {  // A thread of its own, so that no other test is bound.
    cpu_set_t all;
    ASSERT_EQ(::sched_getaffinity(0, sizeof(all), &all), 0);
    int first = 0;
    while (!CPU_ISSET(first, &all)) ++first;
    cpu_set_t one;
    CPU_ZERO(&one);
    CPU_SET(first, &one);
    ASSERT_EQ(::sched_setaffinity(0, sizeof(one), &one), 0);
    with_one = bound();
  })
      .join();
  EXPECT_EQ(with_one, 1);
}

TEST_F(UsableCores, AreNoMoreThanAGroupPaysFor) {
  put("proc/self/cgroup", "0::/jobs/one\n");
  EXPECT_EQ(cores(), bound()) << "no limit is stated";
  put("sys/fs/cgroup/jobs/one/cpu.max", "max 100000\n");
  EXPECT_EQ(cores(), bound());
  put("sys/fs/cgroup/jobs/one/cpu.max", "150000 100000\n");
  EXPECT_EQ(cores(), std::min(bound(), 2)) << "one and a half keep two busy";
  put("sys/fs/cgroup/jobs/cpu.max", "100000 100000\n");
  EXPECT_EQ(cores(), 1) << "a group above leaves less";
  put("sys/fs/cgroup/jobs/cpu.max", "2000 100000\n");
  EXPECT_EQ(cores(), 1) << "at least one works";
}

TEST_F(UsableCores, GroupsOfTheFirstVersionCountToo) {
  put("proc/self/cgroup", "5:memory:/a\n3:cpu,cpuacct:/jobs\n");
  put("sys/fs/cgroup/cpu/jobs/cpu.cfs_quota_us", "-1\n");
  put("sys/fs/cgroup/cpu/jobs/cpu.cfs_period_us", "100000\n");
  EXPECT_EQ(cores(), bound());
  put("sys/fs/cgroup/cpu/jobs/cpu.cfs_quota_us", "100000\n");
  EXPECT_EQ(cores(), 1);
}

}  // namespace
}  // namespace relievo
