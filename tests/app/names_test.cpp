// SPDX-License-Identifier: BSD-3-Clause
// A name is bytes: the verbs take any that a file system allows, and say them in UTF-8.
#include <cmath>
#include <filesystem>
#include <sstream>

#include "tests/app/command_test.h"

namespace relievo {
namespace {

using nlohmann::json;
using test::CommandResult;
using test::runRelievo;

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
  expectDone({"prepare", scan, "-o", named(".ply")});
  expectDone({"render", "--from-image", named(".png"), "-o", named("-2.png")});
  for (const std::string& log : {named(".csv"), named(".h5")}) {
    onScan({"touch"}, {"--stroke", stroke, "-o", log});
    expectDone({"replay", log, "--verify"});
  }
  expectDone({"project", "new", named(".csv"), "--recording", named(".csv"), "-o", named(".json")});
  expectDone({"project", "info", named(".json")});
  EXPECT_EQ(runRelievo({"project", "info", named(".json")}).exit_code, 0) << "for people";
  expectDone({"project", "check", named(".json")});
  expectDone({"project", "package", named(".json"), "-o", named(".zip")});
  expectDone({"project", "verify", named(".zip")});
  expectDone({"replay", named(".zip"), "--verify"});
}

INSTANTIATE_TEST_SUITE_P(Any, Names,
                         testing::Values("caf\xE9", "two\nlines", "quote\"'s", "tab\tbed",
                                         "\xEE\xBE\x80\xFF\\"));

}  // namespace
}  // namespace relievo
