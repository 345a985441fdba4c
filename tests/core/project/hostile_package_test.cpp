// SPDX-License-Identifier: BSD-3-Clause
// Packages that somebody made to read or to fill the disk of whoever checks them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zip.h>

#include <map>

#include "core/base/error.h"
#include "core/project/package.h"
#include "core/provenance/sha256.h"
#include "tests/core/io/temporary_folder.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// A zip of these entries with a manifest that fits them.
fs::path packageOf(const test::TemporaryFolder& folder,
                   std::map<std::string, std::string> entries) {
  std::string manifest;
  for (const auto& [name, text] : entries) {
    manifest.append(sha256OfText(text)).append("  ").append(name).append("\n");
  }
  entries["manifest-sha256.txt"] = manifest;
  const fs::path file = folder.path() / "package.zip";
  int code = 0;
  zip_t* archive = zip_open(file.c_str(), ZIP_CREATE | ZIP_TRUNCATE, &code);
  EXPECT_NE(archive, nullptr);
  for (const auto& [name, text] : entries) {
    zip_file_add(archive, name.c_str(), zip_source_buffer(archive, text.data(), text.size(), 0), 0);
  }
  EXPECT_EQ(zip_close(archive), 0);
  return file;
}

std::string projectWith(const std::string& input, const std::string& recording) {
  Project project;
  project.file = input;
  project.sha256 = std::string(64, '0');
  project.region = {.side_mm = 1, .level = Level{0}};
  project.recordings = {{.file = recording, .sha256 = std::string(64, '0')}};
  return projectJson(project);
}

TEST(HostilePackage, ItsProjectNamesOnlyWhatIsInIt) {
  const test::TemporaryFolder folder;
  const auto problems = [&](const std::string& input, const std::string& recording) {
    const fs::path file = packageOf(folder, {{"project.json", projectWith(input, recording)},
                                             {"input/scan.ply", "a scan"},
                                             {"recordings/log.csv", "a log"}});
    return verifyPackage(file).problems;
  };
  EXPECT_THAT(problems("input/scan.ply", "recordings/log.csv"), IsEmpty());
  EXPECT_THAT(problems("scan.ply", "recordings/log.csv"), IsEmpty()) << "left out on purpose";
  for (const char* outside :
       {"/etc/passwd", "../scan.ply", "input/../../scan.ply", "input/no.ply"}) {
    EXPECT_THAT(problems(outside, "recordings/log.csv"),
                ElementsAre(HasSubstr("outside of the package ('" + std::string(outside))));
  }
  EXPECT_THAT(problems("input/scan.ply", "/etc/passwd"),
              ElementsAre(HasSubstr("outside of the package ('/etc/passwd'")));
}

TEST(HostilePackage, ItsContentsDoNotFillTheDisk) {
  const test::TemporaryFolder folder;
  const std::string zeros(std::size_t{65} << 20U, '\0');
  const fs::path file =
      packageOf(folder, {{"project.json", projectWith("z", "y")}, {"z", zeros}, {"y", "a log"}});
  EXPECT_LT(fs::file_size(file), zeros.size() / 500);
  const auto refused = [](const auto& act) {
    try {
      act();
    } catch (const FileError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_THAT(refused([&] { verifyPackage(file); }), HasSubstr("would unpack to"));
  fs::create_directory(folder.path() / "out");
  EXPECT_THAT(refused([&] { unpackPackage(file, folder.path() / "out"); }),
              HasSubstr("would unpack to"));
  EXPECT_TRUE(fs::is_empty(folder.path() / "out"));
}

TEST(HostilePackage, IsOneOfRelievoOnlyWithAProjectThatCanBeRead) {
  const test::TemporaryFolder folder;
  EXPECT_FALSE(isPackageOfRelievo(folder.path() / "none.zip"));
  const fs::path without = packageOf(folder, {{"README.txt", "Hello"}});
  EXPECT_FALSE(isPackageOfRelievo(without));
  EXPECT_THROW(projectInPackage(without), FileError);
  fs::remove(without);
  const fs::path damaged = packageOf(folder, {{"project.json", "{"}});
  EXPECT_TRUE(isPackageOfRelievo(damaged)) << "its names alone are looked at";
  EXPECT_THROW(projectInPackage(damaged), FileError);
  fs::remove(damaged);
  const fs::path whole = packageOf(folder, {{"project.json", projectWith("input/a.ply", "r.csv")}});
  EXPECT_EQ(projectInPackage(whole).file, "input/a.ply");
}

}  // namespace
}  // namespace relievo
