// SPDX-License-Identifier: BSD-3-Clause
#include "core/project/study.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "core/base/error.h"
#include "tests/core/io/temporary_folder.h"

namespace relievo {
namespace {

Study study(std::uint64_t seed = 1) {
  return {.participant = "P-07",
          .consent = "Form 3 signed on 24 November",
          .conditions = {"fine", "coarse", "\"blurred\", twice"},
          .repetitions = 4,
          .seed = seed};
}

std::string textOf(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

TEST(Study, ShowsEveryConditionOnceInEachBlockAndNoneTwiceInARow) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const std::vector<StudyTrial> trials = trialsOf(study(seed));
    ASSERT_EQ(trials.size(), 12U);
    for (std::size_t block = 0; block < 4; ++block) {
      std::set<std::size_t> met;
      for (std::size_t i = 0; i < 3; ++i) met.insert(trials[3 * block + i].condition);
      EXPECT_EQ(met.size(), 3U) << "seed " << seed << " block " << block;
    }
    for (std::size_t i = 1; i < trials.size(); ++i) {
      EXPECT_NE(trials[i].condition, trials[i - 1].condition) << "seed " << seed << " at " << i;
    }
  }
}

TEST(Study, IsTheSameForASeedAndDealsOrdersAndLettersEvenly) {
  EXPECT_EQ(trialsOf(study(7)), trialsOf(study(7)));
  std::map<std::size_t, int> first;
  std::map<std::string, int> letter_of_fine;
  for (std::uint64_t seed = 0; seed < 900; ++seed) {
    const std::vector<StudyTrial> trials = trialsOf(study(seed));
    ++first[trials.front().condition];
    const auto fine = std::find_if(trials.begin(), trials.end(),
                                   [](const StudyTrial& t) { return t.condition == 0; });
    ++letter_of_fine[fine->blinded];
  }
  // A third each, 300; five standard deviations are 71.
  for (const auto& [condition, count] : first) EXPECT_NEAR(count, 300, 71) << condition;
  ASSERT_EQ(letter_of_fine.size(), 3U);
  for (const auto& [letter, count] : letter_of_fine) EXPECT_NEAR(count, 300, 71) << letter;
}

TEST(Study, HasALetterForEachConditionAndKeepsIt) {
  std::map<std::size_t, std::string> letters;
  for (const StudyTrial& trial : trialsOf(study())) {
    const auto [known, is_new] = letters.emplace(trial.condition, trial.blinded);
    EXPECT_EQ(known->second, trial.blinded);
  }
  std::set<std::string> different;
  for (const auto& [condition, letter] : letters) different.insert(letter);
  EXPECT_EQ(different, (std::set<std::string>{"A", "B", "C"}));
}

TEST(Study, NeedsACodeConsentAndConditions) {
  EXPECT_TRUE(isParticipantCode("P_07-a"));
  for (const char* code :
       {"", "Anna M", "../up", "a/b", "ä", "123456789012345678901234567890123"}) {
    EXPECT_FALSE(isParticipantCode(code)) << code;
    Study named = study();
    named.participant = code;
    EXPECT_THROW(trialsOf(named), ArgumentError) << code;
  }
  Study silent = study();
  silent.consent = " \n";
  EXPECT_THROW(check(silent), ArgumentError);
  Study one = study();
  one.conditions.resize(1);
  EXPECT_THROW(check(one), ArgumentError);
  Study never = study();
  never.repetitions = 0;
  EXPECT_THROW(check(never), ArgumentError);
}

TEST(Study, EachSittingHasAFolderOfItsOwn) {
  const test::TemporaryFolder folder;
  const auto first = makeSittingFolder(folder.path(), "P-07");
  EXPECT_EQ(first, folder.path() / "P-07" / "sitting_01");
  EXPECT_EQ(makeSittingFolder(folder.path(), "P-07").filename(), "sitting_02");
  EXPECT_EQ(makeSittingFolder(folder.path(), "P-08").filename(), "sitting_01");
  const auto file = folder.write("file", "");
  EXPECT_THROW(makeSittingFolder(file, "P-07"), WriteError);
}

TEST(Study, TheKeyAloneSaysWhichLetterIsWhich) {
  const test::TemporaryFolder folder;
  writeSitting(folder.path(), study(),
               {.program = "relievo", .input = "coin.ply", .sha256 = "00", .started_utc = "now"});
  const std::string sitting = textOf(folder.path() / "sitting.json");
  const std::string key = textOf(folder.path() / "key.json");
  for (const char* name : {"fine", "coarse", "blurred"}) {
    EXPECT_EQ(sitting.find(name), std::string::npos) << "blinded: " << name;
    EXPECT_NE(key.find(name), std::string::npos) << name;
  }
  EXPECT_NE(sitting.find("Form 3 signed"), std::string::npos);
  EXPECT_EQ(sitting.find("seed"), std::string::npos) << "it would tell the order";
  EXPECT_NE(key.find("\"seed\": 1"), std::string::npos);
}

TEST(Study, TrialsAreATable) {
  const test::TemporaryFolder folder;
  writeTrials(folder.path(), {{.number = 1,
                               .blinded = "B",
                               .began_utc = "2026-11-24T10:00:00Z",
                               .ended_utc = "2026-11-24T10:01:00Z",
                               .recordings = {"trial_01_B_001.csv", "trial_01_B_002.csv"}},
                              {.number = 2,
                               .blinded = "A",
                               .began_utc = "2026-11-24T10:01:00Z",
                               .ended_utc = {},
                               .recordings = {}}});
  EXPECT_EQ(textOf(folder.path() / "trials.csv"),
            "trial,condition,began_utc,ended_utc,recordings\n"
            "1,B,2026-11-24T10:00:00Z,2026-11-24T10:01:00Z,"
            "\"trial_01_B_001.csv;trial_01_B_002.csv\"\n"
            "2,A,2026-11-24T10:01:00Z,,\"\"\n");
}

}  // namespace
}  // namespace relievo
