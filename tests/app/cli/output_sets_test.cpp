// SPDX-License-Identifier: BSD-3-Clause
// Files that one command writes together: all of them or none, however the command ends.
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <map>
#include <nlohmann/json.hpp>
#include <random>
#include <thread>

#include "core/io/raster/raster.h"
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

/// What `relievo info` says of the files beside one, and of those named.
class OutputSetsTold : public OutputSets {
 protected:
  /// File name -> "same", "other" or "unsaid".
  std::map<std::string, std::string> told(const std::string& main, const Words& with = {}) {
    Words words{"info", in(main), "--report", "json"};
    for (const std::string& file : with) words.insert(words.end(), {"--with", in(file)});
    const CommandResult result = runRelievo(words);
    exit_code_ = result.exit_code;
    errors_ = result.err;
    std::map<std::string, std::string> members;
    const auto report = nlohmann::json::parse(result.out);
    for (const auto& member : report.at("set")) {
      members[fs::path(member.at("file").get<std::string>()).filename()] = member.at("belongs");
    }
    return members;
  }
  int exit_code_ = -1;
  std::string errors_;
};

TEST_F(OutputSetsTold, CountsAndSpreadsOfAnotherMapAreNoticed) {
  const Words words = cases().front().words;
  must(filled(words, cloud("b.csv", 0.3), out()));
  const Files other = files();
  must(filled(words, cloud("a.csv", 0.1), out()));
  const std::map<std::string, std::string> whole = told("site.tif");
  EXPECT_EQ(whole.size(), 4U);
  for (const auto& [name, belongs] : whole) EXPECT_EQ(belongs, "same") << name;
  for (const char* name : {"site.count.tif", "site.spread.tif", "site.colour.tif"}) {
    const std::string kept = bytesOf(in(name));
    write("out/" + std::string(name), other.at(name));
    auto expected = whole;
    expected[name] = "other";
    EXPECT_EQ(told("site.tif"), expected);
    EXPECT_EQ(exit_code_, 0);
    EXPECT_NE(errors_.find(std::string(name) + " was not written with site.tif"), std::string::npos)
        << errors_;
    told("site.tif", {name});
    EXPECT_EQ(exit_code_, 5) << "it was asked";
    write("out/" + std::string(name), kept);
  }
}

TEST_F(OutputSetsTold, LevelsOfAnotherPyramidAreNoticed) {
  const std::string first = cloud("a.csv", 0.1), second = cloud("b.csv", 0.3);
  for (const std::string& scan : {second, first}) {
    must({"pyramid", scan, "--unit", "mm", "--cells", "450", "-o", in("p.tif")});
    if (scan == second) fs::copy_file(in("p.L1.tif"), in("of_second.tif"));
  }
  EXPECT_EQ(told("p.L0.tif").at("p.L1.tif"), "same");
  fs::rename(in("of_second.tif"), in("p.L1.tif"));
  EXPECT_EQ(told("p.L0.tif").at("p.L1.tif"), "other");
}

TEST_F(OutputSetsTold, ThePicturesCaptionEyesAndHeightsAreItsOwnOrNoticed) {
  const std::string scan = cloud("a.csv", 0.1);
  const auto drawn = [&](const std::string& name, const std::string& ending,
                         const std::string& light) {
    must({"figure", scan, "--unit", "mm", "--light", light, "-o", in(name + ending), "--both-eyes",
          "--heights", in(name + ".h.tif"), "--caption", in(name + ".txt"), "--dpi", "60"});
  };
  drawn("two", ".png", "90,45");
  for (const char* ending : {".png", ".svg", ".pdf", ".tif"}) {
    drawn("one", ending, "315,45");
    const std::map<std::string, std::string> own = told(
        "one" + std::string(ending), {"one.h.tif", "one.txt", "one.left.png", "one.right.png"});
    EXPECT_EQ(own.size(), 4U);
    for (const auto& [name, belongs] : own) EXPECT_EQ(belongs, "same") << name << ending;
    EXPECT_EQ(exit_code_, 0);
    for (const char* name : {"two.h.tif", "two.txt", "two.left.png"}) {
      EXPECT_EQ(told("one" + std::string(ending), {name}).at(name), "other") << name << ending;
      EXPECT_EQ(exit_code_, 5);
    }
  }
  must({"render", scan, "--unit", "mm", "-o", in("r.png"), "--caption", in("r.txt")});
  EXPECT_EQ(told("r.png", {"r.txt"}).at("r.txt"), "same");
  EXPECT_EQ(told("r.png", {"one.txt"}).at("one.txt"), "other");
}

TEST_F(OutputSetsTold, DrawingsBelongToTheirTablesAndRecordings) {
  const std::string scan = cloud("a.csv", 0.1);
  const std::string stroke = write("stroke.csv", "t_s,x_mm,y_mm,z_mm\n0,20,20,9\n0.1,25,20,5\n");
  const std::string further = write("further.csv", "t_s,x_mm,y_mm,z_mm\n0,20,20,9\n0.1,30,20,5\n");
  const auto measured = [&](const std::string& name, const std::string& line) {
    must({"measure", scan, "--unit", "mm", "--profile", line, "-o", in(name + ".csv"),
          "--profile-svg", in(name + ".svg")});
  };
  measured("one", "10,10,40,40");
  measured("two", "10,10,40,41");
  EXPECT_EQ(told("one.svg", {"one.csv"}).at("one.csv"), "same");
  EXPECT_EQ(told("two.svg", {"one.csv"}).at("one.csv"), "other");
  const auto touched = [&](const std::string& name, const std::string& along) {
    must({"touch", scan, "--unit", "mm", "--stroke", along, "-o", in(name + ".csv"), "--plot",
          in(name + ".svg")});
  };
  touched("run", stroke);
  touched("other", further);
  must({"touch", scan, "--unit", "mm", "--stroke", stroke, "-o", in("run.h5")});
  const CommandResult recording = runRelievo({"info", in("run.h5")});
  EXPECT_EQ(recording.exit_code, 0) << recording.err;
  EXPECT_NE(recording.out.find("recording of relievo"), std::string::npos) << recording.out;
  EXPECT_EQ(told("run.h5", {"run.svg"}).at("run.svg"), "same");
  EXPECT_EQ(told("other.svg", {"run.h5"}).at("run.h5"), "other");
  EXPECT_EQ(told("run.csv", {"run.svg"}).at("run.svg"), "same");
  EXPECT_EQ(told("run.csv", {"other.svg"}).at("other.svg"), "other");
  EXPECT_EQ(told("run.svg", {"run.csv"}).at("run.csv"), "same");
}

/// The readings are the same, and the scans are not.
TEST_F(OutputSetsTold, TablesOfTwoScansAreNotOneSet) {
  const auto points = [](double far) {
    std::ostringstream text;
    for (int i = 0; i < 2500; ++i) {
      text << i % 50 << ' ' << i / 50 << ' ' << (i == 2499 ? far : 5.0) << '\n';
    }
    return text.str();
  };
  for (const auto& [name, far] : {std::pair{"one", 5.0}, std::pair{"two", 6.0}}) {
    const std::string scan = write("in.xyz", points(far));
    must({"measure", scan, "--unit", "mm", "--view", "top", "--spacing", "1", "--profile",
          "5,5,20,5", "-o", in(name + std::string(".json")), "--profile-csv",
          in(name + std::string(".csv")), "--profile-svg", in(name + std::string(".svg"))});
  }
  EXPECT_EQ(told("one.svg", {"one.csv", "./one.csv"}),
            (std::map<std::string, std::string>{{"one.csv", "same"}}));
  EXPECT_EQ(told("one.svg", {"two.csv"}).at("two.csv"), "other");
  EXPECT_EQ(told("one.svg", {"one.json"}).at("one.json"), "same");
  EXPECT_EQ(told("one.svg", {"two.json"}).at("two.json"), "other");
  EXPECT_NE(runRelievo({"info", in("one.csv")}).out.find("table of relievo"), std::string::npos);
}

TEST_F(OutputSetsTold, ADamagedStateIsToldWithItsFile) {
  must(filled(cases().front().words, cloud("a.csv", 0.1), out()));
  for (const std::string& text :
       {"# relievo:state " + std::string(400, '[') + std::string(400, ']') + "\n1,2,3\n",
        std::string("# relievo:state {\"made\":\n1,2,3\n")}) {
    write("out/odd.csv", text);
    const CommandResult result = runRelievo({"info", in("site.tif"), "--with", in("odd.csv")});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_NE(result.err.find("Cannot read odd.csv"), std::string::npos) << result.err;
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
