// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <regex>
#include <string>
#include <vector>

#include "tests/architecture/source_tree.h"

namespace relievo::architecture {
namespace {

constexpr int kMostLines = 700;
constexpr int kMostFiles = 35;  ///< Of a folder; about 30 is what one takes in (docs/adr/0155).

/// But for the texts of the licences themselves, which REUSE wants as they are.
bool needsLicenceLine(const std::string& path) {
  return !path.starts_with("LICENSES/") && !path.ends_with(".md") && !path.ends_with(".json") &&
         !path.ends_with(".qrc");
}

bool hasLicenceLine(const std::string& text) {
  return text.substr(0, 200).find("SPDX-License-Identifier: BSD-3-Clause") != std::string::npos;
}

bool isTooLong(const std::string& text) {
  return std::count(text.begin(), text.end(), '\n') > kMostLines;
}

/// A path that exists on one machine only. Put together here, so that this file has none.
bool namesAMachine(const std::string& text) {
  static const std::regex kPath("(^|[^A-Za-z0-9_./-])/(home|work|root|Users|opt|mnt)/[A-Za-z0-9]");
  return std::regex_search(text, kPath);
}

bool isUnfinished(const std::string& text) {
  static const std::string kToDo = std::string("TO").append("DO");
  static const std::string kFixMe = std::string("FIX").append("ME");
  return text.find(kToDo) != std::string::npos || text.find(kFixMe) != std::string::npos;
}

TEST(Tree, IsFound) {
  EXPECT_GE(readTree(isText).size(), 1200U);
  EXPECT_GE(readTree(isCpp).size(), 1000U);
}

TEST(Tree, HasALicenceLineInEverySource) {
  for (const auto& [path, text] : readTree(isText)) {
    EXPECT_TRUE(!needsLicenceLine(path) || hasLicenceLine(text)) << path;
  }
}

TEST(Tree, HasNoSourceLongerThanOneCanRead) {
  for (const auto& [path, text] : readTree(isCpp)) EXPECT_FALSE(isTooLong(text)) << path;
}

/// Sources by the folder they lie in.
std::map<std::string, int> filesOfFolders(const std::vector<std::string>& paths) {
  std::map<std::string, int> files;
  for (const std::string& path : paths) ++files[path.substr(0, path.rfind('/'))];
  return files;
}

TEST(Tree, HasNoFolderFullerThanOneCanTakeIn) {
  std::vector<std::string> paths;
  for (const auto& [path, text] : readTree(isCpp)) paths.push_back(path);
  for (const auto& [folder, files] : filesOfFolders(paths)) {
    EXPECT_LE(files, kMostFiles) << folder << ": give it rooms.";
  }
}

TEST(Tree, NamesNoPlaceOnAnyMachine) {
  for (const auto& [path, text] : readTree(isText)) EXPECT_FALSE(namesAMachine(text)) << path;
}

TEST(Tree, LeavesNothingToDoInSources) {
  for (const auto& [path, text] : readTree(isCpp)) EXPECT_FALSE(isUnfinished(text)) << path;
}

TEST(Tree, GuardsEveryHeader) {
  for (const auto& [path, text] : readTree(isCpp)) {
    const bool guarded = text.find("#pragma once") != std::string::npos;
    EXPECT_TRUE(guarded || !path.ends_with(".h")) << path;
  }
}

TEST(TidinessCheck, CatchesWhatItIsFor) {
  EXPECT_FALSE(hasLicenceLine("#pragma once\n"));
  EXPECT_TRUE(isTooLong(std::string(kMostLines + 1, '\n')));
  EXPECT_TRUE(namesAMachine(std::string("open(\"/ho") + "me/somebody/scan.ply\")"));
  EXPECT_FALSE(namesAMachine(std::string("see core/wo") + "rk/flow and build/release"));
  EXPECT_EQ(filesOfFolders({"ui/a.h", "ui/a.cpp", "ui/vtk/b.h"})["ui"], 2);
  EXPECT_TRUE(isUnfinished(std::string("// TO") + "DO: later"));
}

}  // namespace
}  // namespace relievo::architecture
