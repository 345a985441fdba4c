// SPDX-License-Identifier: BSD-3-Clause
// A log takes its name when it is whole; what stood there is never lost.
#include "haptics/record/log/log_place.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "core/base/error.h"
#include "haptics/record/replay.h"
#include "haptics/record/sample_log.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::UnorderedElementsAre;

class LogPlaceTest : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) / ("relievo_log_place_" + std::to_string(::getpid()));
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  fs::path at(const std::string& name) const { return folder_ / name; }
  fs::path old(const std::string& name) const {
    std::ofstream(at(name)) << "old";
    return at(name);
  }
  static std::string textOf(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  std::vector<std::string> names() const {
    std::vector<std::string> found;
    for (const auto& entry : fs::directory_iterator(folder_)) {
      found.push_back(entry.path().filename().string());
    }
    return found;
  }

 private:
  fs::path folder_;
};

void writeRows(SampleLog& log, int rows) {
  for (int i = 0; i < rows; ++i) log.write(HapticSample{}, i / 1000.0);
}

TEST_F(LogPlaceTest, AnEarlierLogStandsUntilTheNewOneIsWhole) {
  for (const char* name : {"a.csv", "a.h5"}) {
    SCOPED_TRACE(name);
    const fs::path file = old(name);
    const auto log = openLog(file, "unit mm", nullptr, LogKind::recording);
    writeRows(*log, 3000);
    EXPECT_EQ(textOf(file), "old");
    log->close();
    EXPECT_NE(textOf(file), "old");
    EXPECT_GT(fs::file_size(file), 100U);
  }
  EXPECT_THAT(names(), UnorderedElementsAre("a.csv", "a.h5"));
}

TEST_F(LogPlaceTest, WhatIsCancelledLeavesWhatWasThere) {
  const fs::path file = old("a.csv");
  {
    const auto stroke = openLog(file, "unit mm");
    writeRows(*stroke, 3000);
  }
  { const auto recording = openLog(file, "unit mm", nullptr, LogKind::recording); }
  { const auto stroke = openLog(at("new.csv"), "unit mm"); }
  EXPECT_THAT(names(), UnorderedElementsAre("a.csv"));
  EXPECT_EQ(textOf(file), "old");
}

TEST_F(LogPlaceTest, RowsOfARecordingThatWasNeverClosedStayBesideTheOldOne) {
  const fs::path file = old("a.csv");
  {
    const auto log = openLog(file, "unit mm", nullptr, LogKind::recording);
    writeRows(*log, 10);
  }
  EXPECT_EQ(textOf(file), "old");
  EXPECT_THAT(textOf(at("a.unfinished.csv")), HasSubstr("\n0.009,"));
}

TEST_F(LogPlaceTest, AKilledRecordingStaysBesideTheOldOneAndIsNotOverwritten) {
  const fs::path file = old("a.csv");
  const pid_t child = ::fork();
  if (child == 0) {
    const auto log = openLog(file, "unit mm", nullptr, LogKind::recording);
    writeRows(*log, 3000);
    ::raise(SIGKILL);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_EQ(textOf(file), "old");
  const std::string left = textOf(at("a.unfinished.csv"));
  EXPECT_GT(left.size(), 60'000U);
  const auto next = openLog(file, "unit mm", nullptr, LogKind::recording);
  writeRows(*next, 1);
  next->close();
  EXPECT_EQ(textOf(at("a.unfinished.csv")), left);
  EXPECT_THAT(names(), UnorderedElementsAre("a.csv", "a.unfinished.csv"));
}

/// Rows that can be read of a recording killed after so many, one a millisecond.
std::size_t rowsLeft(const fs::path& file, int written) {
  const pid_t child = ::fork();
  if (child == 0) {
    const auto log = openLog(file, "unit mm", nullptr, LogKind::recording);
    writeRows(*log, written);
    ::raise(SIGKILL);
  }
  int status = 0;
  EXPECT_EQ(::waitpid(child, &status, 0), child);
  std::size_t rows = 0;
  try {
    rows = readLog(file).rows.size();
  } catch (const FileError& error) {
    EXPECT_THAT(error.what(), HasSubstr("has no rows"));
  }
  fs::remove(file);
  return rows;
}

TEST_F(LogPlaceTest, AKillLosesLessThanHalfASecondAtAnyMoment) {
  for (const char* name : {"k.csv", "k.h5"}) {
    for (const int written : {1, 100, 401, 799, 802, 2399, 5000}) {
      const auto left = static_cast<int>(rowsLeft(at(name), written));
      EXPECT_LE(left, written);
      EXPECT_GT(left, written - 500) << name << ' ' << written;
    }
  }
}

TEST_F(LogPlaceTest, TheSecondWriterOfOneFileIsRefused) {
  for (const bool exists : {false, true}) {
    for (const std::string name : {"b.csv", "b.h5"}) {
      SCOPED_TRACE(name);
      const fs::path file = exists ? old(name) : at(name);
      const auto first = openLog(file, "unit mm", nullptr, LogKind::recording);
      try {
        openLog(file, "unit mm");
        FAIL() << "was accepted";
      } catch (const WriteError& error) {
        EXPECT_EQ(error.code, "E401");
        EXPECT_THAT(error.what(), HasSubstr("being written by another program"));
      }
      writeRows(*first, 5);
      first->close();
      EXPECT_GT(fs::file_size(file), 100U);
      const auto later = openLog(file, "unit mm");
      later->close();
      fs::remove(file);
    }
  }
  EXPECT_TRUE(names().empty());
}

TEST_F(LogPlaceTest, ALinkAndTheModeOfAFileStay) {
  const fs::path file = old("real.csv");
  ASSERT_EQ(::chmod(file.c_str(), 0600), 0);
  fs::create_symlink(file, at("link.csv"));
  const auto log = openLog(at("link.csv"), "unit mm");
  writeRows(*log, 1);
  log->close();
  EXPECT_TRUE(fs::is_symlink(at("link.csv")));
  EXPECT_NE(textOf(file), "old");
  EXPECT_EQ(fs::status(file).permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

TEST_F(LogPlaceTest, WhatALinkNamesIsMadeIfItIsNotThereYet) {
  fs::create_directory(at("there"));
  fs::create_symlink("there/second.csv", at("first.csv"));
  fs::create_symlink("new.csv", at("there/second.csv"));
  const auto log = openLog(at("first.csv"), "unit mm");
  writeRows(*log, 1);
  log->close();
  EXPECT_TRUE(fs::is_symlink(at("first.csv")));
  EXPECT_TRUE(fs::is_symlink(at("there/second.csv")));
  EXPECT_THAT(textOf(at("there/new.csv")), HasSubstr("unit mm"));
}

TEST_F(LogPlaceTest, ALinkThatLeadsNowhereIsRefused) {
  fs::create_symlink("b.csv", at("a.csv"));
  fs::create_symlink("a.csv", at("b.csv"));
  fs::create_symlink("missing/c.csv", at("c.csv"));
  EXPECT_THROW(openLog(at("a.csv"), "unit mm"), WriteError);
  EXPECT_THROW(openLog(at("c.csv"), "unit mm"), WriteError);
  EXPECT_THAT(names(), UnorderedElementsAre("a.csv", "b.csv", "c.csv"));
}

TEST_F(LogPlaceTest, ADeviceIsWrittenAsItIs) {
  const auto log = openLog("/dev/null", "unit mm");
  writeRows(*log, 1);
  EXPECT_NO_THROW(log->close());
}

}  // namespace
}  // namespace relievo
