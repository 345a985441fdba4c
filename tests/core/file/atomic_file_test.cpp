// SPDX-License-Identifier: BSD-3-Clause
#include "core/file/atomic_file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <fstream>
#include <iterator>
#include <set>
#include <string>

#include "core/file/owned_fd.h"
#include "tests/core/io/temporary_folder.h"

namespace relievo {
namespace {

std::set<std::string> namesIn(const std::filesystem::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    names.insert(entry.path().filename().string());
  }
  return names;
}

/// A child that begins to write a file and waits; killed by the caller.
pid_t writerOf(const std::filesystem::path& file, TemporaryName name) {
  std::array<int, 2> ready{};
  EXPECT_EQ(::pipe(ready.data()), 0);
  const pid_t child = ::fork();
  if (child == 0) {
    const AtomicFile written(file, name);
    std::ofstream(written.path()) << "half";
    [[maybe_unused]] const ssize_t told = ::write(ready[1], "x", 1);
    for (;;) ::pause();
  }
  char told = 0;
  EXPECT_EQ(::read(ready[0], &told, 1), 1);
  ::close(ready[0]);
  ::close(ready[1]);
  return child;
}

TEST(AtomicFile, WhatAKilledWriterLeftGoesWhenTheNextOneBegins) {
  const test::TemporaryFolder folder;
  const auto somebodys = folder.write(".map.99999999.tmp.tif", "not of our form");
  folder.write(".map.relievo-x.tmp.tif", "no number");
  folder.write("map.relievo-99999999.tmp.tif", "not hidden");
  const pid_t child = writerOf(folder.path() / "map.tif", TemporaryName::beside);
  const std::string left = ".map.relievo-" + std::to_string(child) + ".tmp.tif";
  EXPECT_TRUE(namesIn(folder.path()).contains(left));
  {
    // While it lives nobody touches it.
    const AtomicFile other(folder.path() / "other.tif");
    EXPECT_TRUE(namesIn(folder.path()).contains(left));
  }
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  EXPECT_TRUE(namesIn(folder.path()).contains(left)) << "nobody could remove it so far";
  { const AtomicFile other(folder.path() / "other.tif"); }
  EXPECT_EQ(namesIn(folder.path()),
            (std::set<std::string>{".map.99999999.tmp.tif", ".map.relievo-x.tmp.tif",
                                   "map.relievo-99999999.tmp.tif"}));
}

/// A writer in another container has a number that means nothing here, but holds its lock.
TEST(AtomicFile, AFileThatSomebodyHoldsIsLeftAlone) {
  const test::TemporaryFolder folder;
  const pid_t child = writerOf(folder.path() / "map.tif", TemporaryName::beside);
  const auto as_if_elsewhere = folder.path() / ".map.relievo-99999999.tmp.tif";
  std::filesystem::rename(folder.path() / (".map.relievo-" + std::to_string(child) + ".tmp.tif"),
                          as_if_elsewhere);
  removeLeftFiles(folder.path());
  EXPECT_TRUE(std::filesystem::exists(as_if_elsewhere));
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  removeLeftFiles(folder.path());
  EXPECT_FALSE(std::filesystem::exists(as_if_elsewhere));
}

TEST(AtomicFile, KeepsWhatWasWrittenAndElseNothing) {
  const test::TemporaryFolder folder;
  const auto file = folder.write("a.txt", "old");
  { std::ofstream(AtomicFile(file).path()) << "half"; }
  EXPECT_EQ(namesIn(folder.path()), std::set<std::string>{"a.txt"});
  {
    AtomicFile written(file);
    std::ofstream(written.path()) << "new";
    written.commit();
  }
  std::ifstream in(file);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(in), {}), "new");
  EXPECT_EQ(namesIn(folder.path()), std::set<std::string>{"a.txt"});
}

TEST(AtomicFile, AKilledWriterLeavesNothingWhereFilesNeedNoName) {
  const test::TemporaryFolder folder;
  const OwnedFd unnamed(::open(folder.path().c_str(), O_TMPFILE | O_RDWR, 0600));
  if (unnamed.get() < 0) GTEST_SKIP() << "Files have names on this file system.";
  const pid_t child = writerOf(folder.path() / "map.tif", TemporaryName::none);
  EXPECT_EQ(namesIn(folder.path()), std::set<std::string>{});
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  EXPECT_EQ(namesIn(folder.path()), std::set<std::string>{});
}

TEST(AtomicFile, TwoMayBeWrittenForOnePlaceAndTheLastOneStays) {
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "a.txt";
  for (const TemporaryName name : {TemporaryName::none, TemporaryName::beside}) {
    AtomicFile first(file, name), second(file, name);
    std::ofstream(first.path()) << "first";
    std::ofstream(second.path()) << "second";
    first.commit();
    second.commit();
    std::ifstream in(file);
    EXPECT_EQ(std::string(std::istreambuf_iterator<char>(in), {}), "second");
    EXPECT_EQ(namesIn(folder.path()), std::set<std::string>{"a.txt"});
  }
}

TEST(AtomicFile, AFileWithoutANameGetsTheModeThatNewFilesHave) {
  namespace fs = std::filesystem;
  const test::TemporaryFolder folder;
  const mode_t before = ::umask(027);
  AtomicFile written(folder.path() / "a.txt");
  ::umask(before);
  std::ofstream(written.path()) << "new";
  written.commit();
  EXPECT_EQ(fs::status(folder.path() / "a.txt").permissions(),
            fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read);
}

TEST(AtomicFile, TakesNamesAsLongAsTheFileSystemDoes) {
  const test::TemporaryFolder folder;
  for (const std::string& ending :
       {std::string(".csv"), std::string(), "." + std::string(200, 'e')}) {
    const std::string start(250 - ending.size(), 'x');
    AtomicFile one(folder.path() / (start + "\xFC" + "one" + ending), TemporaryName::beside);
    AtomicFile other(folder.path() / (start + "\xFC" + "two" + ending), TemporaryName::beside);
    std::ofstream(one.path()) << "1";
    std::ofstream(other.path()) << "2";
    EXPECT_EQ(namesIn(folder.path()).size(), 2U) << "each has its own";
    one.commit();
    other.commit();
    EXPECT_EQ(namesIn(folder.path()), (std::set<std::string>{start + "\xFC" + "one" + ending,
                                                             start + "\xFC" + "two" + ending}));
    for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
      std::filesystem::remove(entry.path());
    }
  }
}

TEST(AtomicFile, KeepsTheModeAndTheLinkOfWhatItReplaces) {
  namespace fs = std::filesystem;
  const test::TemporaryFolder folder;
  const fs::path file = folder.write("a.txt", "old");
  fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write | fs::perms::others_read);
  fs::create_symlink("a.txt", folder.path() / "link.txt");
  AtomicFile written(folder.path() / "link.txt");
  std::ofstream(written.path()) << "new";
  written.commit();
  EXPECT_TRUE(fs::is_symlink(folder.path() / "link.txt"));
  EXPECT_EQ(fs::file_size(file), 3U);
  std::ifstream in(file);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(in), {}), "new");
  EXPECT_EQ(fs::status(file).permissions(),
            fs::perms::owner_read | fs::perms::owner_write | fs::perms::others_read);
}

TEST(AtomicFile, KeepsTheOwnerOfWhatItReplaces) {
  if (::getuid() != 0) GTEST_SKIP() << "Only the superuser can give a file to somebody else.";
  const test::TemporaryFolder folder;
  const auto file = folder.write("a.txt", "old");
  ASSERT_EQ(::chown(file.c_str(), 12, 34), 0);
  AtomicFile written(file);
  std::ofstream(written.path()) << "new";
  written.commit();
  struct stat now {};
  ASSERT_EQ(::stat(file.c_str(), &now), 0);
  EXPECT_EQ(now.st_uid, 12U);
  EXPECT_EQ(now.st_gid, 34U);
}

}  // namespace
}  // namespace relievo
