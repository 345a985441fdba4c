// SPDX-License-Identifier: BSD-3-Clause
// What an exhibit keeps: counts, logs, the staff's number; and when a program is given up.
#include <gmock/gmock.h>

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/exhibit/restart_rule.h"
#include "core/exhibit/rotating_log.h"
#include "core/exhibit/staff_pin.h"
#include "core/exhibit/visit_counts.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class RecordsTest : public testing::Test {
 protected:
  RecordsTest()
      : folder_(fs::path(testing::TempDir()) /
                testing::UnitTest::GetInstance()->current_test_info()->name()) {
    fs::remove_all(folder_);
  }
  ~RecordsTest() override { fs::remove_all(folder_); }
  static std::string read(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  fs::path folder_;
};

TEST_F(RecordsTest, CountsAreKeptByDayAndObjectAndSayNothingElse) {
  {
    VisitCounts counts(folder_);
    counts.start("2026-11-24", "coin");
    counts.touch("2026-11-24", "coin", 1.26);
    counts.start("2026-11-24", "coin");
    counts.save();
    counts.start("2026-11-25", "panel");
    counts.save();
  }
  const VisitCounts again(folder_);
  EXPECT_FALSE(again.problem());
  EXPECT_EQ(again.days().at("2026-11-24").at("coin").starts, 2);
  EXPECT_NEAR(again.days().at("2026-11-24").at("coin").touched_s, 1.3, 1e-9);
  const auto json = nlohmann::json::parse(read(folder_ / "counts.json"));
  EXPECT_EQ(json.size(), 2U);
  EXPECT_EQ(json["days"]["2026-11-25"]["panel"].size(), 2U);
}

TEST_F(RecordsTest, TheNewestFourHundredDaysAreKept) {
  VisitCounts counts(folder_);
  for (int day = 0; day < 450; ++day) counts.start(std::to_string(10000 + day), "coin");
  counts.save();
  const VisitCounts again(folder_);
  EXPECT_EQ(again.days().size(), VisitCounts::kMostDays);
  EXPECT_EQ(again.days().begin()->first, "10050");
}

TEST_F(RecordsTest, DamagedCountsAreSetAsideAndCountingGoesOn) {
  fs::create_directories(folder_);
  std::ofstream(folder_ / "counts.json") << "{\"days\": {\"2026-11-24\": 3}}";
  VisitCounts counts(folder_);
  ASSERT_TRUE(counts.problem());
  EXPECT_THAT(englishText(*counts.problem()), HasSubstr("were set aside"));
  EXPECT_TRUE(fs::exists(folder_ / "counts.damaged.json"));
  counts.start("2026-11-25", "coin");
  counts.save();
  EXPECT_EQ(VisitCounts(folder_).days().size(), 1U);
}

TEST_F(RecordsTest, CountsThatCannotBeWrittenAreAnErrorOfWriting) {
  std::ofstream(folder_.string()) << "a file";
  VisitCounts counts(folder_);
  counts.start("2026-11-24", "coin");
  EXPECT_THROW(counts.save(), WriteError);
  fs::remove(folder_);
}

TEST_F(RecordsTest, ALogRotatesAndKeepsItsNewestLines) {
  RotatingLog log(folder_ / "health.log", {.bytes = 400, .kept = 2});
  for (int i = 0; i < 100; ++i) {
    ASSERT_TRUE(log.write("2026-11-24T00:00:00Z", "line " + std::to_string(i)));
  }
  EXPECT_THAT(read(folder_ / "health.log"), HasSubstr("line 99\n"));
  EXPECT_TRUE(fs::exists(folder_ / "health.log.1"));
  EXPECT_TRUE(fs::exists(folder_ / "health.log.2"));
  EXPECT_FALSE(fs::exists(folder_ / "health.log.3"));
  std::uintmax_t bytes = 0;
  for (const auto& file : fs::directory_iterator(folder_)) bytes += file.file_size();
  EXPECT_LE(bytes, 3 * 450U);
}

TEST_F(RecordsTest, ALineOfALogIsOneLine) {
  RotatingLog log(folder_ / "health.log");
  log.write("T", "two\nlines");
  EXPECT_EQ(read(folder_ / "health.log"), "T two%0Alines\n");
}

TEST_F(RecordsTest, ALogThatCannotBeWrittenSaysSoAndThrowsNothing) {
  std::ofstream(folder_.string()) << "a file";
  EXPECT_FALSE(RotatingLog(folder_ / "health.log").write("T", "words"));
  fs::remove(folder_);
}

void type(StaffLock& lock, const std::string& digits, double now_s = 0) {
  for (const char digit : digits) lock.digit(digit, now_s);
}

TEST(StaffLock, OpensByItsNumberAndByNoOther) {
  StaffLock lock(staffPinOf("2580", "grain"));
  for (const char* wrong : {"2581", "258", "25800", "0852", ""}) {
    type(lock, wrong);
    EXPECT_NE(lock.enter(0), StaffLock::Answer::open) << wrong;
    StaffLock fresh(staffPinOf("2580", "grain"));
    type(fresh, wrong);
    EXPECT_EQ(fresh.enter(0), StaffLock::Answer::wrong) << wrong;
  }
  StaffLock right(staffPinOf("2580", "grain"));
  type(right, "25809");
  right.erase();
  EXPECT_EQ(right.entered(), 4U);
  EXPECT_EQ(right.enter(0), StaffLock::Answer::open);
  EXPECT_EQ(right.entered(), 0U);
}

TEST(StaffLock, AfterFiveTriesItWaitsAMinute) {
  StaffLock lock(staffPinOf("2580", "grain"));
  for (int i = 1; i < StaffLock::kTries; ++i) {
    type(lock, "1111");
    EXPECT_EQ(lock.enter(100), StaffLock::Answer::wrong);
    EXPECT_EQ(lock.triesLeft(), StaffLock::kTries - i);
  }
  type(lock, "1111");
  EXPECT_EQ(lock.enter(100), StaffLock::Answer::waits);
  type(lock, "2580", 159);
  EXPECT_EQ(lock.entered(), 0U);
  EXPECT_EQ(lock.enter(159), StaffLock::Answer::waits);
  EXPECT_EQ(lock.waitsS(160), 0);
  type(lock, "2580", 160);
  EXPECT_EQ(lock.enter(160), StaffLock::Answer::open);
}

TEST(StaffPin, TheSameNumberLooksDifferentUnderAnotherSalt) {
  EXPECT_NE(staffPinOf("2580", "a").sha256, staffPinOf("2580", "b").sha256);
  EXPECT_FALSE(isPin("258"));
  EXPECT_FALSE(isPin("25a0"));
  EXPECT_FALSE(isPin("1234567890123"));
  EXPECT_TRUE(isPin("0000"));
}

TEST(RestartRule, GivesUpAfterFiveEndsWithinTenMinutes) {
  RestartRule rule;
  for (int i = 0; i < 4; ++i) EXPECT_TRUE(rule.ended(100.0 * i));
  EXPECT_FALSE(rule.ended(599));
  EXPECT_EQ(rule.recentEnds(), 5);
}

TEST(RestartRule, OneEndNowAndThenIsNone) {
  RestartRule rule;
  for (int i = 0; i < 100; ++i) EXPECT_TRUE(rule.ended(151.0 * i));
}

}  // namespace
}  // namespace relievo
