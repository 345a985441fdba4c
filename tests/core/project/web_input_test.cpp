// SPDX-License-Identifier: BSD-3-Clause
// What is made of a map from the web names its address, and finds by it what was opened before.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "core/project/embedded_state.h"
#include "core/project/package.h"
#include "core/project/project_files.h"
#include "core/provenance/provenance.h"
#include "core/session/large/tiled_surface.h"
#include "core/tiles/published/publish.h"
#include "core/tiles/published/published_tiles.h"
#include "tests/core/tiles/slow_web_server.h"
#include "tests/core/tiles/small_map.h"
#include "tests/core/tiles/tile_fixtures.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;

class WebInput : public testing::Test {
 protected:
  void SetUp() override {
    ::setenv("XDG_CACHE_HOME", (folder_ / "cache").c_str(), 1);
    test::writeSmallMap(folder_ / "map.tif", {.cols = 400, .rows = 300});
    publish(TiledMap(folder_ / "map.tif"), folder_ / "web", {});
    server_ =
        std::make_unique<test::SlowWebServer>(folder_ / "web", test::SlowWebServer::Options{});
    kept_ = webMap(address()).manifest;
    fs::create_directories(folder_ / "work");
  }
  std::string address() const { return server_->address(); }
  Project projectOfMap() const {
    const InputFile input = inputFile(kept_, {});
    Project project;
    project.file = kept_.string();
    project.sha256 = input.sha256;
    project.bytes = input.bytes;
    project.region = {.x_mm = 5, .y_mm = 5, .side_mm = 20, .level = {0}};
    return project;
  }
  std::string storedAddress(const fs::path& project) const {
    std::ifstream in(project);
    return projectFromJson(std::string(std::istreambuf_iterator<char>(in), {}), "p").file;
  }

  const test::TileFolder folder_;
  std::unique_ptr<test::SlowWebServer> server_;
  fs::path kept_;
};

TEST_F(WebInput, AProjectKeepsTheAddressAndFindsWhatWasOpened) {
  const fs::path written = folder_ / "work/p.relievo.json";
  writeProject(written, projectOfMap());
  EXPECT_EQ(storedAddress(written), address());
  const Project read = readProject(written);
  EXPECT_EQ(read.file, address()) << "an address is no path below the project's folder";
  EXPECT_EQ(foundInput(written, read.file), kept_);
  for (const FileCheck& check : checkFiles(read)) EXPECT_EQ(check.state, FileState::as_before);

  // Saved again as it was read, and from another folder.
  fs::create_directories(folder_ / "work/deeper");
  writeProject(folder_ / "work/deeper/q.relievo.json", read);
  EXPECT_EQ(storedAddress(folder_ / "work/deeper/q.relievo.json"), address());
}

TEST_F(WebInput, AnAddressThatWasNeverOpenedIsNamedWhole) {
  const std::string elsewhere = "https://maps.example.org/site/web";
  try {
    foundInput(folder_ / "work/p.relievo.json", elsewhere);
    FAIL() << "nothing was opened by that address";
  } catch (const FileError& error) {
    EXPECT_NE(std::string(error.what()).find(elsewhere), std::string::npos) << error.what();
  }
  EXPECT_EQ(checkFile({.file = elsewhere, .sha256 = "0"}).state, FileState::missing);
}

TEST_F(WebInput, WhatIsMadeOfItNamesTheAddress) {
  const Surface surface = openTiledSurface(kept_);
  Provenance made = provenanceOf(projectOfMap(), surface, folder_ / "work");
  EXPECT_EQ(made.input.file, address());
  const auto shown = embeddedProject(folder_ / "work/figure.png", toJson(made, -1));
  ASSERT_TRUE(shown);
  EXPECT_EQ(shown->file, address());
}

TEST_F(WebInput, APackageHasTheAddressInPlaceOfTheMap) {
  const fs::path package = folder_ / "work/p.zip";
  writePackage(package, projectOfMap(), {.with_input = true});
  const PackageCheck check = verifyPackage(package);
  EXPECT_TRUE(check.problems.empty()) << check.problems.front();
  fs::create_directories(folder_ / "unpacked");
  unpackPackage(package, folder_ / "unpacked");
  EXPECT_FALSE(fs::exists(folder_ / "unpacked/input")) << "a map.json alone opens nothing";
  const Project packed = readProject(folder_ / "unpacked/project.json");
  EXPECT_EQ(packed.file, address());
  EXPECT_EQ(packed.sha256, projectOfMap().sha256);
}

}  // namespace
}  // namespace relievo
