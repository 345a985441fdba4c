// SPDX-License-Identifier: BSD-3-Clause
// From a map by tiles to a folder, and from its address to facts, a picture and a touch, which is
// played back and filmed by the address as well.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/app/command.h"
#include "tests/core/tiles/slow_web_server.h"
#include "tests/core/tiles/tile_fixtures.h"

namespace relievo {
namespace {

using json = nlohmann::json;
using test::CommandResult;
using test::runRelievo;

class PublishVerb : public testing::Test {
 protected:
  void SetUp() override {
    ::setenv("XDG_CACHE_HOME", (folder_ / "cache").c_str(), 1);
    std::ofstream grid(folder_ / "relief.asc");
    grid << "ncols 600\nnrows 500\nxllcorner 0\nyllcorner 0\ncellsize 1\n";
    for (int row = 0; row < 500; ++row) {
      for (int col = 0; col < 600; ++col) grid << (row * 7 + col * 3) % 50 << ' ';
      grid << '\n';
    }
    grid.close();
    succeeds(
        {"depthmap", path("relief.asc"), "--unit", "mm", "--memory", "400", "-o", path("map.tif")});
  }
  std::string path(const std::string& name) const { return folder_ / name; }
  static std::string succeeds(const std::vector<std::string>& words) {
    const CommandResult result = runRelievo(words);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return result.out;
  }
  std::vector<std::string> publishing(const std::string& map) const {
    return {"publish",   map,          "-o",       path("web"), "--licence",
            "CC-BY-4.0", "--citation", "Me, 2026", "--report",  "json"};
  }
  static void refuses(const std::vector<std::string>& words, int exit_code,
                      const std::string& sentence) {
    const CommandResult result = runRelievo(words);
    EXPECT_EQ(result.exit_code, exit_code) << result.err;
    EXPECT_NE(result.err.find(sentence), std::string::npos) << result.err;
  }

  /// Of another computer, on which no address was opened.
  void forgetWhatWasOpened() const { std::filesystem::remove_all(folder_ / "cache"); }
  std::string touchOn(const std::string& map) const {
    std::ofstream(path("press.csv")) << "t_s,x_mm,y_mm,z_mm\n0,0,0,20\n0.2,0,0,-10\n";
    succeeds({"touch", map, "--stroke", path("press.csv"), "--frame", "device", "-o", path("a.csv"),
              "--report", "json"});
    return path("a.csv");
  }
  static std::vector<std::string> replaying(const std::string& log, const std::string& input) {
    return {"replay", log, "--verify", "--input", input, "--report", "json"};
  }
  std::vector<std::string> filming(const std::string& log, const std::string& input) const {
    return {"video", log,      "--input", input, "--frame",
            "1",     "--size", "320x180", "-o",  path("frame.png")};
  }

  test::TileFolder folder_;
};

TEST_F(PublishVerb, WhatIsPublishedIsLookedAtAndTouchedByItsAddress) {
  const json done = json::parse(succeeds(publishing(path("map.tif"))));
  EXPECT_GT(done["tiles"], 0);
  test::SlowWebServer server(path("web"), {});
  const json info = json::parse(succeeds({"info", server.address() + "/", "--report", "json"}));
  EXPECT_EQ(info["licence"], "CC-BY-4.0");
  EXPECT_EQ(info["citation"], "Me, 2026");
  EXPECT_EQ(info["place"], server.address());
  EXPECT_EQ(info["sha256"], done["sha256"]);
  EXPECT_EQ(info["levels"][0]["cells"], json({600, 500}));

  std::ofstream(path("press.csv")) << "t_s,x_mm,y_mm,z_mm\n0,0,0,20\n0.2,0,0,-10\n";
  const auto touch = [&](const std::string& map, const std::string& out) {
    json report = json::parse(succeeds({"touch", map, "--stroke", path("press.csv"), "--frame",
                                        "device", "-o", path(out), "--report", "json"}));
    EXPECT_GT(report["contact_ticks"], 0);
    return report;
  };
  EXPECT_EQ(touch(server.address(), "a.csv"), touch(path("map.tif"), "b.csv"));
  std::ifstream log(path("a.csv"));
  const std::string text{std::istreambuf_iterator<char>(log), {}};
  EXPECT_NE(text.find(server.address()), std::string::npos) << "the recording names the address";

  succeeds({"render", server.address(), "-o", path("web.png"), "--pixels", "64"});
  EXPECT_TRUE(std::filesystem::exists(path("web.png")));
}

TEST_F(PublishVerb, ARecordingIsPlayedBackAndFilmedByTheAddressOfItsMap) {
  succeeds(publishing(path("map.tif")));
  test::SlowWebServer server(path("web"), {});
  const std::string log = touchOn(server.address());
  server.stop();
  forgetWhatWasOpened();
  test::SlowWebServer moved(path("web"), {});
  succeeds(filming(log, moved.address()));
  std::ifstream frame(path("frame.png"), std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(frame), {}};
  EXPECT_NE(bytes.find(moved.address()), std::string::npos) << "the picture names the address";

  forgetWhatWasOpened();
  const json replay = json::parse(succeeds(replaying(log, moved.address() + "/")));
  EXPECT_TRUE(replay["identical"]);
  EXPECT_GT(replay["ticks"], 0);
  EXPECT_EQ(replay["input"], moved.address());

  moved.stop();  // What was looked at is here.
  const CommandResult kept = runRelievo(replaying(log, moved.address()));
  EXPECT_EQ(kept.exit_code, 0) << kept.err;
  EXPECT_NE(kept.err.find("gives no answer. The map is shown as it was"), std::string::npos)
      << kept.err;
}

TEST_F(PublishVerb, TheAddressInARecordingIsNotAskedByItself) {
  succeeds(publishing(path("map.tif")));
  test::SlowWebServer server(path("web"), {});
  const std::string log = touchOn(server.address());
  const std::vector<std::string> by_itself{"replay", log, "--verify", "--report", "json"};
  const int asked = server.requests();
  const json replay = json::parse(succeeds(by_itself));
  EXPECT_TRUE(replay["identical"]);
  EXPECT_EQ(replay["input"], server.address());
  EXPECT_EQ(server.requests(), asked) << "what was opened before is here";
  forgetWhatWasOpened();
  refuses(by_itself, 2, "which is not there (E501)");
  refuses({"video", log, "-o", path("v.mp4")}, 2, "which is not there (E501)");
  EXPECT_EQ(server.requests(), asked) << "who made the recording does not choose the server";
}

TEST_F(PublishVerb, SaysWhatIsWrongWithTheMapOfARecording) {
  succeeds(publishing(path("map.tif")));
  test::SlowWebServer server(path("web"), {});
  const std::string address = server.address(), log = touchOn(address);
  forgetWhatWasOpened();
  server.damage(".tiles");
  for (const auto& words : {replaying(log, address), filming(log, address)}) {
    refuses(words, 2, "of the published map " + address + " is damaged");
  }
  forgetWhatWasOpened();
  server.stop();
  for (const auto& words : {replaying(log, address), filming(log, address)}) {
    refuses(words, 2, "The map " + address + " cannot be fetched now");
  }

  succeeds({"publish", path("map.tif"), "-o", path("other"), "--licence", "CC0-1.0", "--citation",
            "Somebody else, 2026"});
  test::SlowWebServer other(path("other"), {});
  refuses(filming(log, other.address()), 5,
          "'" + other.address() + "' is not the file that a.csv was made from (checksum differs");
}

TEST_F(PublishVerb, SaysInASentenceWhatIsWrong) {
  refuses(publishing(path("relief.asc")), 1, "is no map by tiles");
  refuses(publishing(path("none.tif")), 2, "none.tif");
  refuses({"publish", path("map.tif"), "-o", path("web")}, 1, "licence");
  succeeds(publishing(path("map.tif")));
  refuses(publishing(path("map.tif")), 3, "there is something already");
  refuses({"info", "http://127.0.0.1:9/map"}, 2, "cannot be fetched now");
}

}  // namespace
}  // namespace relievo
