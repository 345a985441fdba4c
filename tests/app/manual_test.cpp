// SPDX-License-Identifier: BSD-3-Clause
// Manual pages and completions say what the command line takes, neither less nor more.
#include "app/manual/manual.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <regex>
#include <set>
#include <sstream>

#include "tests/app/command.h"

namespace relievo::manual {
namespace {

using test::runRelievo;
using testing::Contains;
using testing::HasSubstr;
using testing::UnorderedElementsAre;

const CommandLine& line() {
  static const CommandLine kLine = commandLine();
  return kLine;
}

const CommandRow& verb(const std::string& name) {
  for (const CommandRow& row : line().verbs) {
    if (row.name == name) return row;
  }
  throw std::out_of_range(name);
}

struct Ran {
  int exit_code = -1;
  std::string out;  ///< Both streams.
};

Ran run(const std::string& command) {
  Ran ran;
  std::FILE* const pipe = popen((command + " 2>&1").c_str(), "r");
  std::array<char, 4096> part{};
  for (std::size_t n = 0; (n = std::fread(part.data(), 1, part.size(), pipe)) > 0;) {
    ran.out.append(part.data(), n);
  }
  ran.exit_code = WEXITSTATUS(pclose(pipe));
  return ran;
}

bool isThere(const std::string& program) {
  return run("command -v " + program).exit_code == 0;
}

std::string share(const std::string& name) {
  return RELIEVO_BINARY_DIR "/share/" + name;
}

std::string textOf(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// What bash offers for the last word, sorted by bash.
std::vector<std::string> offered(const std::vector<std::string>& words) {
  std::string list;
  for (const std::string& word : words) list += " '" + word + "'";
  const Ran ran = run("bash -c '. \"" + share("bash-completion/completions/relievo") +
                      "\"; COMP_WORDS=(\"$@\"); COMP_CWORD=$(($# - 1)); _relievo; printf \"%s\\n\" "
                      "\"${COMPREPLY[@]}\"' bash" +
                      list);
  EXPECT_EQ(ran.exit_code, 0) << ran.out;
  std::vector<std::string> found;
  std::istringstream in(ran.out);
  for (std::string word; std::getline(in, word);) {
    if (!word.empty()) found.push_back(word);
  }
  return found;
}

TEST(Manual, TheTableHasEveryVerbAndWhatItTakes) {
  EXPECT_GE(line().verbs.size(), 15U);
  EXPECT_EQ(verb("depthmap").positionals.front().names.front(), "FILE");
  EXPECT_TRUE(verb("depthmap").positionals.front().required);
  const auto option = [](const std::string& name) -> const OptionRow& {
    for (const OptionRow& row : verb("touch").options) {
      if (row.names.back() == name) return row;
    }
    throw std::out_of_range(name);
  };
  EXPECT_THAT(option("--reader").words, UnorderedElementsAre("auto", "pcl", "own"));
  EXPECT_EQ(option("--stiffness").value, "FLOAT:0.001 to 100 N/mm");
  EXPECT_EQ(option("--keep-withheld").value, "");
}

/// Options that a help text declares at the beginning of a line, "--report".
std::set<std::string> declaredBy(std::vector<std::string> words) {
  words.emplace_back("--help");
  const std::string help = runRelievo(words).out;
  const std::regex option("\\n  (?:-[a-zA-Z],)?(--[a-z][a-z-]*)");
  std::set<std::string> names;
  for (std::sregex_iterator i(help.begin(), help.end(), option), end; i != end; ++i) {
    names.insert((*i)[1]);
  }
  return names;
}

/// By the program that runs: the table alone would agree with itself.
TEST(Manual, TheTableIsWhatHelpPrints) {
  const auto names_of = [](const CommandRow& row) {
    std::set<std::string> names;
    for (const OptionRow& option : row.options) names.insert(option.names.back());
    return names;
  };
  std::size_t parts = 0;
  for (const CommandRow& row : line().verbs) {
    EXPECT_EQ(names_of(row), declaredBy({row.name})) << row.name;
    const std::string help = runRelievo({row.name, "--help"}).out;
    const std::size_t listed = help.find("\nSubcommands:\n");
    EXPECT_EQ(listed == std::string::npos, row.parts.empty()) << row.name;
    for (const CommandRow& part : row.parts) {
      ++parts;
      EXPECT_NE(help.find("\n  " + part.name + " ", listed), std::string::npos) << part.name;
      EXPECT_EQ(names_of(part), declaredBy({row.name, part.name})) << row.name << part.name;
    }
  }
  EXPECT_EQ(parts, 5U);
}

TEST(Manual, PartsOfAVerbAreOnItsPageAndCompleted) {
  const std::string page = pages(line()).at("relievo-devices.1");
  for (const CommandRow& part : verb("devices").parts) {
    EXPECT_THAT(page, HasSubstr("\n.SS " + part.name + "\n" + part.help.substr(0, 20)))
        << part.name;
    std::vector<std::string> names;
    for (const OptionRow& option : part.options) {
      names.insert(names.end(), option.names.begin(), option.names.end());
    }
    EXPECT_THAT(offered({"relievo", "devices", part.name, "-"}),
                testing::UnorderedElementsAreArray(names));
  }
  EXPECT_THAT(page, HasSubstr("\\fB\\-\\-accept\\fR"));
  EXPECT_THAT(offered({"relievo", "devices", "se"}), UnorderedElementsAre("selftest"));
  EXPECT_THAT(offered({"relievo", "devices", "firmware", "--re"}),
              testing::Not(Contains("--report")));
}

TEST(Manual, EveryPageNamesEveryOptionWithItsHelp) {
  const auto all = pages(line());
  ASSERT_EQ(all.size(), line().verbs.size() + 1);
  for (const CommandRow& row : line().verbs) {
    const std::string& page = all.at("relievo-" + row.name + ".1");
    EXPECT_THAT(all.at("relievo.1"), HasSubstr("\\fB" + row.name + "\\fR"));
    for (const OptionRow& option : row.options) {
      EXPECT_FALSE(option.help.empty()) << row.name << " " << option.names.back();
      for (std::string name : option.names) {
        for (std::size_t at = 0; (at = name.find('-', at)) != std::string::npos; at += 2) {
          name.insert(at, "\\");
        }
        EXPECT_THAT(page, HasSubstr("\\fB" + name + "\\fR")) << row.name;
      }
    }
  }
}

TEST(Manual, ThePagesAreRoffThatNothingIsWrongWith) {
  if (!isThere("groff")) GTEST_SKIP() << "groff is not installed";
  for (const auto& [name, text] : pages(line())) {
    const Ran ran =
        run("groff -man -Tutf8 -ww -rF0 '" + share("man/man1/" + name) + "' >/dev/null");
    EXPECT_EQ(ran.exit_code, 0) << name;
    EXPECT_EQ(ran.out, "") << name;
    EXPECT_EQ(textOf(share("man/man1/" + name)), text) << "what is installed is not what is made";
  }
  const Ran shown = run("groff -man -Tascii -P-cbou '" + share("man/man1/relievo-touch.1") + "'");
  EXPECT_THAT(shown.out, HasSubstr("--level-stiffness FLOAT:0.001 to 100 N/mm"));
}

TEST(Manual, BashCompletesVerbsOptionsWordsAndFiles) {
  EXPECT_THAT(offered({"relievo", "de"}), UnorderedElementsAre("depthmap", "describe", "devices"));
  EXPECT_THAT(offered({"relievo", "touch", "scan.ply", "--re"}),
              UnorderedElementsAre("--reader", "--region", "--report"));
  EXPECT_THAT(offered({"relievo", "depthmap", "scan.ply", "--reader", ""}),
              UnorderedElementsAre("auto", "own", "pcl"));
  EXPECT_THAT(offered({"relievo", "--lang", "d"}), UnorderedElementsAre("de"));
  EXPECT_TRUE(offered({"relievo", "touch", "--stiffness", ""}).empty()) << "a number";
  const std::string folder = RELIEVO_SOURCE_DIR "/data/samples/";
  EXPECT_THAT(offered({"relievo", "depthmap", folder + "coi"}), Contains(folder + "coin.ply"));
  EXPECT_THAT(offered({"relievo", folder + "coi"}), Contains(folder + "coin.ply"));
  for (const CommandRow& row : line().verbs) {
    std::vector<std::string> names;
    for (const OptionRow& option : row.options) {
      names.insert(names.end(), option.names.begin(), option.names.end());
    }
    EXPECT_THAT(offered({"relievo", row.name, "-"}), testing::UnorderedElementsAreArray(names));
  }
}

TEST(Manual, ZshAndFishUnderstandTheirs) {
  for (const auto& [shell, file] : {std::pair{"zsh", "zsh/vendor-completions/_relievo"},
                                    std::pair{"fish", "fish/vendor_completions.d/relievo.fish"}}) {
    const std::string text = textOf(share(file));
    for (const CommandRow& row : line().verbs) {
      EXPECT_THAT(text, HasSubstr(row.name)) << shell;
      for (const OptionRow& option : row.options) {
        const std::string& name = option.names.back();
        EXPECT_THAT(text,
                    HasSubstr(shell == std::string("zsh") ? name + "[" : " -l " + name.substr(2)))
            << row.name;
      }
    }
    if (!isThere(shell)) continue;  // Both are among .ci/packages.txt.
    const Ran ran = run(std::string(shell) + " -n '" + share(file) + "'");
    EXPECT_EQ(ran.exit_code, 0) << ran.out;
  }
}

}  // namespace
}  // namespace relievo::manual
