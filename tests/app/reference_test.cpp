// SPDX-License-Identifier: BSD-3-Clause
// docs/user/reference.md names every verb and every option, and none that is not there.
#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "tests/app/command.h"

namespace relievo {
namespace {

using Words = std::set<std::string>;

Words found(const std::string& text, const std::string& pattern) {
  const std::regex regex(pattern);
  Words words;
  for (std::sregex_iterator i(text.begin(), text.end(), regex), end; i != end; ++i) {
    words.insert((*i)[1]);
  }
  return words;
}

Words optionsIn(const std::string& text) {
  return found(text, "(?:^|[^-\\w])(--[a-z][a-z-]*)");
}

/// Those that a help text declares; what its words mention is no option of its own.
Words declaredIn(const std::string& help) {
  return found(help, "\\n  (?:-[a-z],)?(--[a-z][a-z-]*)");
}

std::string helpOf(const std::vector<std::string>& verb) {
  static std::map<std::vector<std::string>, std::string> known;
  std::string& help = known[verb];
  if (help.empty()) {
    std::vector<std::string> words = verb;
    words.emplace_back("--help");
    const test::CommandResult result = test::runRelievo(words);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    help = result.out;
  }
  return help;
}

/// The page's parts by their headings.
std::map<std::string, std::string> parts() {
  std::ifstream in(RELIEVO_SOURCE_DIR "/docs/user/reference.md");
  std::map<std::string, std::string> parts;
  std::string heading;
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("## ")) heading = line.substr(3);
    parts[heading] += line + '\n';
  }
  return parts;
}

/// The part on a verb, and what is said about many verbs.
std::string pageOn(const std::string& verb) {
  std::string text;
  for (const auto& [heading, part] : parts()) {
    const std::string name = "relievo " + verb;
    if (heading == name || heading.starts_with(name + " ")) text += part;
  }
  EXPECT_FALSE(text.empty()) << "no part on " << verb;
  return text + parts()["Options of many verbs"];
}

constexpr std::array<const char*, 5> kPartsOfDevices{"firmware", "selftest", "calibrate", "rule",
                                                     "library"};

TEST(Reference, NamesEveryOptionOfEveryVerb) {
  const std::string help = helpOf({});
  const Words verbs = found(help.substr(help.find("Verbs:")), "\\n  ([a-z]+) ");
  EXPECT_EQ(verbs.size(), 20U) << help;
  for (const std::string& verb : verbs) {
    Words options = declaredIn(helpOf({verb}));
    if (verb == "devices") {
      for (const char* part : kPartsOfDevices) {
        options.merge(declaredIn(helpOf({verb, part})));
      }
    }
    EXPECT_TRUE(options.contains("--help")) << verb;
    const Words named = optionsIn(pageOn(verb));
    for (const std::string& option : options) {
      EXPECT_TRUE(named.contains(option)) << verb << ' ' << option << " is not in the reference";
    }
  }
  const Words named = optionsIn(parts()["The window"]);
  for (const std::string& option : optionsIn(help.substr(0, help.find("Verbs:")))) {
    EXPECT_TRUE(named.contains(option)) << option << " of the window is not in the reference";
  }
}

TEST(Reference, NamesNoOptionThatIsNotThere) {
  const std::string help = helpOf({});
  Words known = optionsIn(help);
  Words verbs = found(help.substr(help.find("Verbs:")), "\\n  ([a-z]+) ");
  for (const std::string& verb : verbs) known.merge(declaredIn(helpOf({verb})));
  for (const char* part : kPartsOfDevices) {
    known.merge(declaredIn(helpOf({"devices", part})));
  }
  for (const auto& [heading, part] : parts()) {
    for (const std::string& option : optionsIn(part)) {
      EXPECT_TRUE(known.contains(option)) << heading << ": there is no " << option;
    }
  }
}

}  // namespace
}  // namespace relievo
