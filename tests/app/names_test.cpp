// SPDX-License-Identifier: BSD-3-Clause
// A name is bytes: the verbs take any that a file system allows, and say them in UTF-8.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <sstream>

#include "tests/app/command_test.h"

namespace relievo {
namespace {

using nlohmann::json;
using test::CommandResult;
using test::runRelievo;

/// As the JSON library sees it, which is strict.
bool isUtf8(const std::string& text) {
  try {
    json(text).dump();
    return true;
  } catch (const json::exception&) {
    return false;
  }
}

class Names : public test::CommandTest, public testing::WithParamInterface<const char*> {
 protected:
  std::string named(const std::string& ending) const { return path(GetParam() + ending); }

  /// Done, without a word of a library, and with a report that is one.
  static void expectDone(const std::vector<std::string>& words) {
    const CommandResult result = runRelievo(test::joined(words, {"--report", "json"}));
    EXPECT_EQ(result.exit_code, 0) << words[0] << ": " << result.err;
    EXPECT_EQ(result.err.find("json.exception"), std::string::npos) << words[0] << result.err;
    EXPECT_TRUE(json::parse(result.out, nullptr, false).is_object()) << words[0] << result.out;
  }
};

TEST_P(Names, OfScansLogsProjectsAndPackagesGoThroughTheVerbs) {
  std::ostringstream points;
  for (int row = 0; row < 40; ++row) {
    for (int col = 0; col < 40; ++col) {
      points << 0.5 * col << ' ' << 0.5 * row << ' ' << 2 + std::sin(0.5 * col) << '\n';
    }
  }
  const std::string scan = write(GetParam() + std::string(".xyz"), points.str());
  const std::string stroke =
      write(GetParam() + std::string(".stroke"), "t_s,x_mm,y_mm,z_mm\n0,8,8,5\n0.05,8,8,1\n");
  const auto onScan = [&](std::vector<std::string> words, const std::vector<std::string>& more) {
    words.insert(words.end(), {scan, "--unit", "mm"});
    if (words[0] != "info") words.insert(words.end(), {"--view", "top"});
    return expectDone(test::joined(words, more));
  };
  onScan({"info"}, {});
  onScan({"depthmap"}, {"-o", named(".tif")});
  onScan({"pyramid"}, {"-o", named("-p.tif")});
  onScan({"render"}, {"-o", named(".png")});
  onScan({"measure"}, {"--point", "3,3"});
  expectDone({"convert", scan, named(".asc"), "--unit", "mm", "--view", "top"});
  expectDone({"prepare", scan, "-o", named(".ply"), "--write-recipe", named(".recipe")});
  expectDone({"prepare", "--recipe", named(".recipe"), "-o", named("-2.ply")});
  expectDone({"render", "--from-image", named(".png"), "-o", named("-2.png")});
  for (const std::string& log : {named(".csv"), named(".h5")}) {
    onScan({"touch"}, {"--stroke", stroke, "-o", log});
    expectDone({"replay", log, "--verify"});
  }
  const std::vector<std::string> record{"record", scan,       "--unit",  "mm",        "--view",
                                        "top",    "--device", "virtual", "--seconds", "0.2"};
  for (const std::string& log : {named("-r.csv"), named("-r.h5")}) {
    expectDone(test::joined(record, {"--stroke", stroke, "-o", log}));
  }
  expectDone({"video", named(".csv"), "--size", "320x180", "-o", named(".mp4")});
  expectDone(
      {"video", named(".h5"), "--size", "320x180", "--profile", "images", "-o", named("-frames")});
  onScan({"figure"}, {"--dpi", "40", "-o", named(".pdf")});
  expectDone({"render", "--from-image", named(".pdf"), "-o", named("-3.png")});
  expectDone({"project", "new", named(".csv"), "--recording", named(".csv"), "-o", named(".json")});
  expectDone({"project", "info", named(".json")});
  EXPECT_EQ(runRelievo({"project", "info", named(".json")}).exit_code, 0) << "for people";
  expectDone({"project", "check", named(".json")});
  expectDone({"project", "package", named(".json"), "-o", named(".zip")});
  expectDone({"project", "verify", named(".zip")});
  expectDone({"replay", named(".zip"), "--verify"});
}

TEST_P(Names, AddNoLinesToHeadersAndCaptions) {
  const std::string scan = write(GetParam() + std::string(".xyz"), test::bytesOf(plane()));
  const std::string stroke =
      write(GetParam() + std::string(".stroke"), "t_s,x_mm,y_mm,z_mm\n0,50,50,20\n0.01,50,50,9\n");
  const std::vector<std::string> of_scan{scan, "--unit", "mm", "--view", "top"};
  const auto linesOf = [](const std::string& file) {
    std::vector<std::string> lines;
    std::istringstream text(test::bytesOf(file));
    for (std::string line; std::getline(text, line);) lines.push_back(line);
    return lines;
  };
  expectDone(
      test::joined(test::joined({"touch"}, of_scan), {"--stroke", stroke, "-o", named(".csv")}));
  const auto log = linesOf(named(".csv"));
  const auto columns = std::find_if(
      log.begin(), log.end(), [](const std::string& line) { return line.starts_with("t_s,"); });
  ASSERT_NE(columns, log.end());
  const std::string plain = write("plain.xyz", test::bytesOf(scan));
  const std::string stroke_2 = write("plain.stroke", test::bytesOf(stroke));
  expectDone({"touch", plain, "--unit", "mm", "--view", "top", "--stroke", stroke_2, "-o",
              path("plain.csv")});
  const auto other = linesOf(path("plain.csv"));
  EXPECT_EQ(log.size(), other.size()) << "as many lines as with plain names";
  for (auto line = log.begin(); line != columns; ++line) {
    EXPECT_EQ(line->front(), '#') << *line;
    EXPECT_TRUE(isUtf8(*line)) << *line;
  }
  EXPECT_EQ(std::count_if(log.begin(), columns,
                          [](const std::string& line) { return line.starts_with("# input "); }),
            1);
  expectDone(test::joined(test::joined({"measure"}, of_scan),
                          {"--profile", "10,10,90,90", "-o", named("-m.csv"), "--profile-csv",
                           named("-p.csv"), "--profile-svg", named("-p.svg")}));
  for (const char* table : {"-m.csv", "-p.csv", "-p.svg"}) {
    for (const std::string& line : linesOf(named(table))) EXPECT_TRUE(isUtf8(line)) << line;
  }
  expectDone(test::joined(test::joined({"figure"}, of_scan),
                          {"--dpi", "40", "--caption", named(".txt"), "-o", named(".svg")}));
  EXPECT_EQ(linesOf(named(".txt")).size(), 1U) << test::bytesOf(named(".txt"));
  for (const std::string& line : linesOf(named(".svg"))) EXPECT_TRUE(isUtf8(line)) << line;
}

INSTANTIATE_TEST_SUITE_P(Any, Names,
                         testing::Values("caf\xE9", "two\nlines", "quote\"'s", "tab\tbed",
                                         "\xEE\xBE\x80\xFF\\", "100%41&<b>"));

}  // namespace
}  // namespace relievo
