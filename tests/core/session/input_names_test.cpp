// SPDX-License-Identifier: BSD-3-Clause
#include "core/session/input_names.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "core/base/error.h"
#include "tests/core/io/temporary_folder.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

class InputNames : public ::testing::Test {
 protected:
  InputNames() {
    for (const char* name : {"b.las", "a.LAZ", "c.ply", "notes.pdf", "scan.xyz"}) {
      folder_.write(name, "x");
    }
    fs::create_directories(at("deep/er"));
    folder_.write("deep/er/d.las", "x");
  }
  fs::path at(const std::string& name) const { return folder_.path() / name; }
  /// Names of the files, from the folder.
  std::vector<std::string> named(const std::vector<fs::path>& names) const {
    std::vector<std::string> found;
    for (const fs::path& file : filesNamed(names)) {
      found.push_back(fs::weakly_canonical(file)
                          .lexically_relative(fs::weakly_canonical(folder_.path()))
                          .generic_string());
    }
    return found;
  }
  std::string refusal(const fs::path& name) const {
    try {
      filesNamed({name});
    } catch (const FileError& error) {
      return error.what();
    }
    return "nothing was refused";
  }
  test::TemporaryFolder folder_;
};

TEST_F(InputNames, AFileThatIsThereOrNotStaysAsItIsGiven) {
  EXPECT_THAT(filesNamed({"nowhere/at all.las"}), ElementsAre(fs::path("nowhere/at all.las")));
  EXPECT_THAT(filesNamed({at("scan.xyz")}), ElementsAre(at("scan.xyz")));
}

TEST_F(InputNames, AFolderStandsForItsCloudsSorted) {
  EXPECT_THAT(named({folder_.path()}), ElementsAre("a.LAZ", "b.las", "c.ply"));
}

TEST_F(InputNames, APatternFitsFilesAndFolders) {
  EXPECT_THAT(named({at("*.la*")}), ElementsAre("b.las"));
  EXPECT_THAT(named({at("?.*")}), ElementsAre("a.LAZ", "b.las", "c.ply"));
  EXPECT_THAT(named({at("d*/*r/*.las")}), ElementsAre("deep/er/d.las"));
  EXPECT_THAT(refusal(at("*.e57")), HasSubstr("No file fits"));
}

TEST_F(InputNames, AListNamesFilesFromItsOwnFolder) {
  folder_.write("deep/all.txt", "# site\n\n  ../b.las\r\ner/d.las\n../b.las\n");
  EXPECT_THAT(named({at("deep/all.txt")}), ElementsAre("b.las", "deep/er/d.las"));
  folder_.write("wrong.lst", "b.las\nz.las\n");
  EXPECT_THAT(refusal(at("wrong.lst")), HasSubstr("z.las"));
  folder_.write("points.txt", "1 2 3\n4 5 6\n");
  EXPECT_THAT(filesNamed({at("points.txt")}), ElementsAre(at("points.txt"))) << "it is a scan";
}

TEST_F(InputNames, ATileIndexNamesFilesFromItsOwnFolder) {
  folder_.write("site.vpc", R"({"type": "FeatureCollection", "features": [
    {"type": "Feature", "assets": {"data": {"href": "./b.las"}}},
    {"type": "Feature", "assets": {"points": {"href": "deep/er/d.las"}}}]})");
  EXPECT_THAT(named({at("site.vpc")}), ElementsAre("b.las", "deep/er/d.las"));
  folder_.write("index.geojson", R"({"type": "FeatureCollection", "features": [
    {"type": "Feature", "properties": {"location": "c.ply"}, "geometry": null}]})");
  EXPECT_THAT(named({at("index.geojson")}), ElementsAre("c.ply"));
  folder_.write("web.vpc", R"({"type": "FeatureCollection", "features": [
    {"assets": {"data": {"href": "https://example.org/a.laz"}}}]})");
  EXPECT_THAT(refusal(at("web.vpc")), HasSubstr("no file of this computer"));
  for (const std::string& bad :
       {std::string(R"({"type": "FeatureCollection", "features": [{}]})"),
        std::string(R"({"type": "FeatureCollection")"),
        R"({"type": "FeatureCollection", "features": )" + std::string(100'000, '[')}) {
    folder_.write("bad.vpc", bad);
    EXPECT_THAT(refusal(at("bad.vpc")), HasSubstr("cannot be read as a tile index"));
  }
}

TEST_F(InputNames, NeitherTheOrderOfNamesNorNamingTwiceShows) {
  const std::vector<std::string> all = named({at("c.ply"), at("b.las"), at("a.LAZ")});
  EXPECT_THAT(all, ElementsAre("a.LAZ", "b.las", "c.ply"));
  fs::create_symlink(at("b.las"), at("deep/link.las"));
  EXPECT_EQ(named({folder_.path(), at("deep/link.las"), at("b.las")}), all);
}

TEST_F(InputNames, AFolderWithoutCloudsIsRefused) {
  EXPECT_THAT(refusal(at("deep")), HasSubstr("no LAS, LAZ or PLY file"));
}

}  // namespace
}  // namespace relievo
