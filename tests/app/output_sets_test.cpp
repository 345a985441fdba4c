// SPDX-License-Identifier: BSD-3-Clause
// Files that one command writes together: all of them or none, however the command ends.
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <map>
#include <random>
#include <thread>

#include "core/io/raster.h"
#include "core/tiles/tile_raster.h"
#include "tests/app/command_test.h"

namespace relievo::test {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;
using Files = std::map<std::string, std::string>;

class OutputSets : public CommandTest {
 protected:
  OutputSets() { fs::create_directory(out()); }

  fs::path out() const { return folder_.path() / "out"; }
  std::string in(const std::string& name) const { return (out() / name).string(); }

  /// A slope of a place, coloured, as text.
  std::string cloud(const std::string& name, double slope) const {
    std::ostringstream text;
    text << "x,y,z,r,g,b\n";
    for (int y = 0; y <= 60; ++y) {
      for (int x = 0; x <= 60; ++x) {
        text << x << ',' << y << ',' << 5 + slope * x << ',' << 40 + x << ',' << 90 + y << ",7\n";
      }
    }
    return write(name, text.str());
  }
  /// Hidden ones too.
  Files files() const {
    Files all;
    for (const auto& entry : fs::directory_iterator(out())) {
      if (!entry.is_regular_file()) continue;
      all[entry.path().filename().string()] = bytesOf(entry.path().string());
    }
    return all;
  }
  void must(const Words& words) const {
    const CommandResult result = runRelievo(words);
    ASSERT_EQ(result.exit_code, 0) << result.err;
  }
  /// Starts it, waits a while and kills it. @return it had not ended by itself
  bool killed(Words words, std::chrono::microseconds after) const {
    words.insert(words.begin(), RELIEVO_BINARY_DIR "/bin/relievo");
    std::vector<char*> argv;
    argv.reserve(words.size() + 1);
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    const pid_t child = ::fork();
    if (child == 0) {
      const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
      ::dup2(nowhere, STDOUT_FILENO);
      ::dup2(nowhere, STDERR_FILENO);
      ::execv(argv[0], argv.data());
      ::_exit(126);
    }
    std::this_thread::sleep_for(after);  // The moment is what is random here.
    ::kill(child, SIGKILL);
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFSIGNALED(status);
  }
};

struct Case {
  const char* name;
  Words words;  ///< SCAN and OUT stand for files.
  /// A file that comes after others, of which nothing is known before the work.
  const char* blocked;
};

Words filled(Words words, const std::string& scan, const fs::path& out) {
  for (std::string& word : words) {
    if (word == "SCAN") word = scan;
    if (word.starts_with("OUT/")) word = (out / word.substr(4)).string();
  }
  return words;
}

const std::vector<Case>& cases() {
  static const std::vector<Case> all{
      {"depthmap",
       {"depthmap", "SCAN", "--unit", "mm", "--view", "top", "--cells", "61", "--quality", "-o",
        "OUT/site.tif"},
       "site.spread.tif"},
      {"pyramid",
       {"pyramid", "SCAN", "--unit", "mm", "--view", "top", "--cells", "450", "-o", "OUT/site.tif"},
       "site.L1.colour.tif"},
      {"measure",
       {"measure", "SCAN", "--unit", "mm", "--view", "top", "--cells", "61", "--profile=5,5,50,50",
        "--profile-csv", "OUT/p.csv", "--profile-svg", "OUT/p.svg", "-o", "OUT/all.csv"},
       "all.csv"},
      {"convert",
       {"convert", "SCAN", "--unit", "mm", "--view", "top", "--cells", "61", "OUT/site.tif"},
       "site.origin.tif"}};
  return all;
}

TEST_F(OutputSets, AreAsBeforeWhereOneOfThemCannotBeWritten) {
  const std::string first = cloud("a.csv", 0.1), second = cloud("b.csv", 0.3);
  for (const Case& c : cases()) {
    SCOPED_TRACE(c.name);
    must(filled(c.words, first, out()));
    fs::remove(out() / c.blocked);
    const Files before = files();
    ASSERT_GE(before.size(), 2U);
    fs::create_directory(out() / c.blocked);
    const CommandResult result = runRelievo(filled(c.words, second, out()));
    EXPECT_EQ(result.exit_code, 3) << result.err;
    EXPECT_TRUE(files() == before) << result.err;
    fs::remove_all(out());
    fs::create_directory(out());
  }
}

TEST_F(OutputSets, OfAKilledCommandAreWholeAndOfOneSetOrTellThatTheyAreNot) {
  const std::string first = cloud("a.csv", 0.1), second = cloud("b.csv", 0.3);
  const Case& c = cases().front();
  must(filled(c.words, second, out()));
  const Files of_second = files();
  must(filled(c.words, first, out()));
  const Files of_first = files();
  std::mt19937 random(21);
  std::uniform_int_distribution<int> moment(1'000, 400'000);
  int killed_ones = 0;
  for (int i = 0; i < 25; ++i) {
    if (killed(filled(c.words, i % 2 == 0 ? second : first, out()),
               std::chrono::microseconds(moment(random)))) {
      ++killed_ones;
    }
    for (const auto& [name, text] : files()) {
      if (name.starts_with(".")) continue;
      ASSERT_TRUE(of_first.contains(name)) << name;
      EXPECT_TRUE(text == of_first.at(name) || text == of_second.at(name)) << name << " is neither";
    }
    const RasterMap map = readRaster(out() / "site.tif");
    const RasterFacts of_map = rasterFacts(out() / "site.tif");
    const RasterFacts of_origins = rasterFacts(out() / "site.origin.tif");
    EXPECT_EQ(map.origins.empty(), of_map.at(kSetFact) != of_origins.at(kSetFact));
  }
  EXPECT_GT(killed_ones, 0) << "the moments miss the command";
  must(filled(c.words, first, out()));
  EXPECT_TRUE(files() == of_first) << "something was left behind";
}

TEST_F(OutputSets, AllSayWhichSetTheyAreOf) {
  must(filled(cases().front().words, cloud("a.csv", 0.1), out()));
  const std::string set = rasterFacts(out() / "site.tif").at(kSetFact);
  EXPECT_EQ(set.size(), 64U);
  for (const char* name :
       {"site.origin.tif", "site.colour.tif", "site.count.tif", "site.spread.tif"}) {
    EXPECT_EQ(rasterFacts(out() / name).at(kSetFact), set) << name;
  }
}

TEST_F(OutputSets, HaveNoMemberOfAnEarlierOne) {
  const std::string scan = cloud("a.csv", 0.1);
  must(filled(cases()[0].words, scan, out()));
  Words less = filled(cases()[0].words, scan, out());
  std::erase(less, "--quality");
  must(less);
  EXPECT_FALSE(files().contains("site.count.tif"));
  EXPECT_FALSE(files().contains("site.spread.tif"));
  Words levels = filled(cases()[1].words, scan, out());
  must(levels);
  ASSERT_TRUE(files().contains("site.L1.tif"));
  ASSERT_TRUE(files().contains("site.L1.colour.tif"));
  write("out/site.L9.tif", "somebody's");
  const std::size_t before = files().size();
  std::replace(levels.begin(), levels.end(), std::string("450"), std::string("61"));
  must(levels);
  EXPECT_LT(files().size(), before);
  EXPECT_FALSE(files().contains("site.L1.tif"));
  EXPECT_FALSE(files().contains("site.L1.colour.tif"));
  EXPECT_TRUE(files().contains("site.L9.tif"));
}

}  // namespace
}  // namespace relievo::test
