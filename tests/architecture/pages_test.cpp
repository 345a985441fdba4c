// SPDX-License-Identifier: BSD-3-Clause
// What a newcomer reads first is as the tree is: files that pages name are there, each module says
// the same five things of itself, and every decision stands in the index once
// and names the ones that changed it.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/architecture/include_table.h"
#include "tests/architecture/source_tree.h"

namespace relievo::architecture {
namespace {

namespace fs = std::filesystem;

const fs::path kRoot = RELIEVO_SOURCE_DIR;

bool isPage(const std::string& path) {
  return path.ends_with(".md");
}

const std::map<std::string, std::string>& pages() {
  static const std::map<std::string, std::string> all = readTree(isPage);
  return all;
}

/// Files of sources and pages that a page names in back quotes, with or without their folder.
std::set<std::string> filesNamedIn(const std::string& page) {
  static const std::regex kFile(R"(`([A-Za-z0-9_/.-]+\.(?:h|cpp|md|txt|inc|ts|py|cmake|xml))`)");
  std::set<std::string> files;
  for (std::sregex_iterator i(page.begin(), page.end(), kFile), end; i != end; ++i) {
    files.insert((*i)[1]);
  }
  return files;
}

/// From the root, from the page's folder, or from that of a file that the same page names.
bool isThere(const std::string& file, const fs::path& folder, const std::set<std::string>& named) {
  if (fs::exists(kRoot / file) || fs::exists(folder / file)) return true;
  return std::any_of(named.begin(), named.end(), [&](const std::string& other) {
    const fs::path beside = (kRoot / other).parent_path() / file;
    return other.find('/') != std::string::npos && fs::exists(beside);
  });
}

bool isPlaceholder(const std::string& file) {
  const std::string name = fs::path(file).filename().string();
  return name == "verb_x.cpp" || name == "read_x.cpp" || name == "read_x_test.cpp" ||
         name == "x_panel.h";
}

TEST(Pages, NameFilesThatAreThere) {
  for (const auto& [path, text] : pages()) {
    const bool is_for_newcomers = path.ends_with("README.md") || path == "docs/architecture.md" ||
                                  path == "docs/threads.md" || path == "docs/dev/how_to_add.md" ||
                                  path == "CONTRIBUTING.md";
    if (!is_for_newcomers) continue;
    const std::set<std::string> named = filesNamedIn(text);
    for (const std::string& file : named) {
      if (isPlaceholder(file)) continue;
      EXPECT_TRUE(isThere(file, (kRoot / path).parent_path(), named)) << path << " names " << file;
    }
  }
}

/// Folders that the table of includes knows as modules, and those above them.
std::set<std::string> moduleFolders() {
  std::set<std::string> folders{"core", "haptics", "plugins", "ui", "app", "tests"};
  const auto tables = readTree(
      [](const std::string& path) { return path == "tests/architecture/allowed_includes.txt"; });
  for (const ModuleRule& rule : parseTable(tables.begin()->second).modules) {
    folders.insert(rule.name);
  }
  return folders;
}

/// What a README lacks of: what, from where, to where, threads, where to start.
std::vector<std::string> lacking(const std::string& folder, const std::string& readme) {
  std::vector<std::string> words;
  if (!readme.starts_with("# " + folder + "\n\n- What: ")) words.emplace_back("What");
  for (const char* word : {"From", "To", "Threads", "Start with"}) {
    if (readme.find("\n- " + std::string(word) + ": ") == std::string::npos) {
      words.emplace_back(word);
    }
  }
  return words;
}

/// Those and the rooms of a module that the table puts in order.
std::set<std::string> foldersWithReadme() {
  std::set<std::string> folders = moduleFolders();
  const auto tables = readTree(
      [](const std::string& path) { return path == "tests/architecture/allowed_includes.txt"; });
  for (const RoomsRule& rule : parseTable(tables.begin()->second).rooms) {
    for (const auto& row : rule.rows) {
      for (const std::string& room : row) {
        folders.insert(std::string(rule.folder).append("/").append(room));
      }
    }
  }
  return folders;
}

TEST(Pages, EveryModuleAndRoomSaysTheSameFiveThings) {
  for (const std::string& folder : foldersWithReadme()) {
    const auto readme = pages().find(folder + "/README.md");
    ASSERT_NE(readme, pages().end()) << folder << " has no README.md";
    for (const std::string& word : lacking(folder, readme->second)) {
      ADD_FAILURE() << folder << "/README.md does not say \"" << word << "\"";
    }
  }
}

TEST(Pages, TheTableOfTheArchitectureHasEveryModule) {
  const std::string& page = pages().at("docs/architecture.md");
  for (const std::string& folder : moduleFolders()) {
    const bool is_row = page.find("\n| " + folder + " |") != std::string::npos;
    EXPECT_TRUE(is_row || folder == "core" || folder == "haptics" || folder == "plugins") << folder;
  }
}

struct Decision {
  std::set<std::string> changes;  ///< Numbers of records of which it replaces or changes a part.
  std::string status;             ///< The paragraph below the title.
};

std::map<std::string, Decision> decisions() {
  std::map<std::string, Decision> all;
  for (const auto& [path, text] : pages()) {
    if (!path.starts_with("docs/adr/0")) continue;
    std::istringstream lines(text);
    Decision decision;
    std::string line;
    std::getline(lines, line);  // The title, and an empty line.
    std::getline(lines, line);
    while (std::getline(lines, line) && !line.empty()) decision.status += line + ' ';
    // Each sentence of the status that begins with what it does to others.
    static const std::regex kSentence(
        R"((?:Replaces|Changes|Narrows|Supersedes|Extends|Adds to)[^;.]*(?:\.md\)[^;.]*)*)");
    const std::string& status = decision.status;
    for (std::sregex_iterator i(status.begin(), status.end(), kSentence), end; i != end; ++i) {
      static const std::regex kLink(R"(\]\((\d{4})-)");
      const std::string sentence = i->str();
      for (std::sregex_iterator j(sentence.begin(), sentence.end(), kLink); j != end; ++j) {
        decision.changes.insert((*j)[1]);
      }
    }
    all[fs::path(path).filename().string().substr(0, 4)] = decision;
  }
  return all;
}

TEST(Decisions, StandInTheIndexOnce) {
  const std::string& index = pages().at("docs/adr/README.md");
  for (const auto& [number, decision] : decisions()) {
    const std::string row = "| [" + number + "](" + number + "-";
    const std::size_t at = index.find(row);
    ASSERT_NE(at, std::string::npos) << number << " is not in docs/adr/README.md";
    EXPECT_EQ(index.find(row, at + 1), std::string::npos) << number << " stands there twice";
  }
}

/// Whoever reads a decision that was changed later hears of it there.
TEST(Decisions, ThatWereChangedSayByWhich) {
  const std::map<std::string, Decision> all = decisions();
  for (const auto& [number, decision] : all) {
    for (const std::string& earlier : decision.changes) {
      ASSERT_TRUE(all.contains(earlier)) << number << " changes " << earlier;
      EXPECT_NE(all.at(earlier).status.find(number + "-"), std::string::npos)
          << earlier << " was changed by " << number << " and does not say so below its title";
    }
  }
}

TEST(PagesCheck, CatchesWhatItIsFor) {
  const std::set<std::string> named = filesNamedIn("`core/base/vec3.h`, `gone.h`, `word`");
  EXPECT_EQ(named, (std::set<std::string>{"core/base/vec3.h", "gone.h"}));
  EXPECT_TRUE(isThere("error.h", kRoot, named)) << "beside one that is named with its folder";
  EXPECT_FALSE(isThere("gone.h", kRoot, named));
  EXPECT_EQ(lacking("core/x", "# core/x\n\n- What: a\n- From: b\n- To: c\n- Threads: d\n"),
            std::vector<std::string>{"Start with"});
  EXPECT_EQ(lacking("core/y", "# core/x\n\n- What: a\n- From: b\n- To: c\n- Threads: d\n").size(),
            2U);
}

}  // namespace
}  // namespace relievo::architecture
