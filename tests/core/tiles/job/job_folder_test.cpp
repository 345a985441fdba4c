// SPDX-License-Identifier: BSD-3-Clause
#include "core/tiles/job/job_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>

#include "core/base/error.h"
#include "tests/core/tiles/tile_fixtures.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

const JobFacts kFacts{{"the program", "1"}, {"what the files hold", "abc"}, {"an option", "x"}};

std::string refusal(const fs::path& folder, const JobFacts& facts) {
  try {
    const JobFolder job(folder, facts);
  } catch (const ArgumentError& error) {
    return error.what();
  }
  return "nothing was refused";
}

TEST(JobFolder, KeepsPartsForTheSameWork) {
  const test::TileFolder folder;
  const fs::path place = folder / "a/job";
  {
    JobFolder job(place, kFacts);
    EXPECT_FALSE(job.load("points/1.part"));
    job.keep("points/1.part", {"some ", "content"});
    job.keep("heights/1.part", {""});
    EXPECT_EQ(job.load("points/1.part"), "some content");
  }
  JobFolder job(place, kFacts);
  EXPECT_EQ(job.load("points/1.part"), "some content");
  EXPECT_EQ(job.load("heights/1.part"), "");
  EXPECT_EQ(job.damaged(), 0);
  std::string read(4, ' ');
  readPart(job.fileOf("points/1.part"), 5, std::as_writable_bytes(std::span(read)));
  EXPECT_EQ(read, "cont");
  job.remove("points");
  EXPECT_FALSE(job.load("points/1.part"));
  job.finish();
  EXPECT_FALSE(fs::exists(place));
}

TEST(JobFolder, FindsEveryByteThatWasChangedAndEveryCut) {
  const test::TileFolder folder;
  JobFolder job(folder / "job", kFacts);
  job.keep("points/1.part", {"some content"});
  const fs::path file = job.fileOf("points/1.part");
  std::string good;
  {
    std::ifstream in(file, std::ios::binary);
    good.assign(std::istreambuf_iterator<char>(in), {});
  }
  const auto is_taken = [&](const std::string& bytes) {
    std::ofstream(file, std::ios::binary) << bytes;
    return job.load("points/1.part").has_value();
  };
  for (std::size_t at = 0; at < good.size(); ++at) {
    std::string bad = good;
    bad[at] = static_cast<char>(bad[at] ^ 1);
    EXPECT_FALSE(is_taken(bad)) << at;
    EXPECT_FALSE(is_taken(good.substr(0, at))) << at;
  }
  EXPECT_FALSE(is_taken(good + "x"));
  EXPECT_EQ(job.damaged(), static_cast<int>(2 * good.size() + 1));
  EXPECT_TRUE(is_taken(good));
  // Under another name it is another part.
  fs::rename(file, job.fileOf("points/2.part"));
  EXPECT_FALSE(job.load("points/2.part"));
}

TEST(JobFolder, RefusesOtherWorkAndSaysWhatDiffers) {
  const test::TileFolder folder;
  { const JobFolder job(folder / "job", kFacts); }
  for (const auto& [name, what] : kFacts) {
    JobFacts other = kFacts;
    for (auto& [one, value] : other) value += one == name ? "!" : "";
    EXPECT_THAT(refusal(folder / "job", other), HasSubstr(name + " differs"));
  }
  EXPECT_EQ(refusal(folder / "job", kFacts), "nothing was refused");
}

TEST(JobFolder, LeavesForeignFoldersAlone) {
  const test::TileFolder folder;
  std::ofstream(folder / "thesis.odt") << "mine";
  EXPECT_THAT(refusal(folder.path(), kFacts), HasSubstr("holds no work of this program"));
  EXPECT_TRUE(fs::exists(folder / "thesis.odt"));
  const auto entries = fs::directory_iterator(folder.path());
  EXPECT_EQ(std::distance(begin(entries), end(entries)), 1);
  JobFolder job(folder / "job", kFacts);
  std::ofstream(folder / "job/note.txt") << "mine";
  job.finish();
  EXPECT_TRUE(fs::exists(folder / "job/note.txt"));
}

TEST(JobFolder, HasOneProcessAtATime) {
  const test::TileFolder folder;
  const JobFolder job(folder / "job", kFacts);
  EXPECT_THAT(refusal(folder / "job", kFacts), HasSubstr("Another process works"));
}

TEST(JobFolder, SaysWhatCannotBeWritten) {
  const test::TileFolder folder;
  std::ofstream(folder / "file") << "x";
  EXPECT_THROW(JobFolder(folder / "file/job", kFacts), WriteError);
}

}  // namespace
}  // namespace relievo
