// SPDX-License-Identifier: BSD-3-Clause
// What archives and forges read says the same as the project itself.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>
#include <string>

namespace relievo::architecture {
namespace {

std::string textOf(const std::string& name) {
  std::ifstream in(RELIEVO_SOURCE_DIR "/" + name, std::ios::binary);
  EXPECT_TRUE(in.is_open()) << name;
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

std::string found(const std::string& text, const std::string& pattern) {
  std::smatch match;
  return std::regex_search(text, match, std::regex(pattern)) ? match[1].str() : std::string();
}

TEST(ReleaseFiles, SayTheProjectsVersionTitleAndLicence) {
  const std::string version =
      found(textOf("CMakeLists.txt"), "project\\(relievo VERSION ([0-9.]+)");
  ASSERT_EQ(version, RELIEVO_VERSION_STRING);
  const std::string citation = textOf("CITATION.cff");
  const auto zenodo = nlohmann::json::parse(textOf(".zenodo.json"));
  EXPECT_EQ(found(citation, "\nversion: ([0-9.]+)\n"), version);
  EXPECT_EQ(zenodo.at("version"), version);
  EXPECT_EQ(found(citation, "\ntitle: \"([^\"]+)\""), zenodo.at("title"));
  EXPECT_EQ(found(citation, "\nlicense: (\\S+)"), "BSD-3-Clause");
  EXPECT_EQ(zenodo.at("license"), "BSD-3-Clause");
  const std::string authors = found(textOf("LICENSE"), "Copyright \\(c\\) 2026, (.+)\n");
  EXPECT_EQ(found(citation, "\nauthors:\n  - name: \"([^\"]+)\""), authors);
  EXPECT_EQ(zenodo.at("creators").at(0).at("name"), authors);
}

TEST(ReleaseFiles, TheForgeRunsWhatEverybodyRuns) {
  const std::string workflow = textOf(".github/workflows/ci.yml");
  EXPECT_THAT(workflow, testing::HasSubstr("run: .ci/run\n"));
  EXPECT_THAT(workflow, testing::HasSubstr("container: debian:12"));
}

/// A container installs what .ci/packages.txt lists, what our own packages recommend, and no more.
TEST(ReleaseFiles, TheContainerHasThePackagesOfTheProject) {
  const std::string file = textOf("docs/user/Dockerfile");
  EXPECT_THAT(file, testing::HasSubstr("FROM debian:12 AS build\n"));
  EXPECT_THAT(file,
              testing::HasSubstr("sed -e 's/#.*//' .ci/packages.txt | xargs apt-get install"));
  const std::string known = textOf(".ci/packages.txt") + textOf("cmake/packages.cmake");
  std::istringstream installed(
      found(file, "apt-get install -y --no-install-recommends (/tmp/[^&]+) &&"));
  int packages = 0;
  for (std::string package; installed >> package; ++packages) {
    std::smatch own;  // One of ours, by its file.
    if (std::regex_match(package, own, std::regex("/tmp/([a-z-]+)_\\*\\.deb"))) {
      EXPECT_THAT(known, testing::HasSubstr("PACKAGE_NAME " + own.str(1) + ")\n"));
      continue;
    }
    EXPECT_THAT(known, testing::ContainsRegex("[\n \",]" + package + "[\n \",]"));
  }
  EXPECT_GT(packages, 2);
  const std::string presets = textOf("CMakePresets.json");
  EXPECT_THAT(file, testing::HasSubstr("cmake --preset package &&"));
  EXPECT_THAT(presets, testing::HasSubstr("{ \"name\": \"package\""));
}

/// What the text points to is there.
TEST(ReleaseFiles, NamePagesThatAreThere) {
  for (const char* name : {".github/SECURITY.md", ".github/ISSUE_TEMPLATE/device.md",
                           ".github/ISSUE_TEMPLATE/fault.md", ".github/CODE_OF_CONDUCT.md"}) {
    const std::string text = textOf(name);
    EXPECT_GT(text.size(), 300U) << name;
    const std::regex page("docs/[a-z_/-]+\\.md");
    for (std::sregex_iterator at(text.begin(), text.end(), page), end; at != end; ++at) {
      textOf(at->str());
    }
  }
}

}  // namespace
}  // namespace relievo::architecture
