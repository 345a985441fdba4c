// SPDX-License-Identifier: BSD-3-Clause
// Every number that a verb takes has a range, and no option takes an empty text.
#include <gtest/gtest.h>
#include <CLI/CLI.hpp>

#include <functional>
#include <set>

#include "app/cli/options/number_option.h"
#include "app/cli/verb.h"
#include "app/draw/drawing_verbs.h"

namespace relievo::batch {
namespace {

using Visit = std::function<void(const std::string& verb, const CLI::Option& option)>;

void visit(const std::string& verb, CLI::App& app, const Visit& each) {
  for (const CLI::Option* option : app.get_options()) each(verb, *option);
  for (CLI::App* sub : app.get_subcommands({})) visit(verb + " " + sub->get_name(), *sub, each);
}

/// All options of all verbs, as the program declares them.
void forEveryOption(const Visit& each) {
  setDrawing(ownDrawing());  // Else the verbs that draw have no options.
  for (Verb& verb : verbs()) {
    CLI::App app(verb.help, verb.name);
    verb.declare(app);
    refuseEmptyTexts(app);
    visit(verb.name, app, each);
  }
}

bool takesValues(const CLI::Option& option) {
  return option.get_expected_max() > 0;
}

bool takesNumber(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  return type.starts_with("FLOAT") || type.starts_with("INT") || type.starts_with("UINT");
}

/// Why the option refuses this text; empty: it takes it.
std::string refusalOf(const CLI::Option& option, const std::string& text) {
  // CLI11 checks only what it parses: a parser with this option alone.
  CLI::App alone;
  std::string value;
  CLI::Option* copy = alone.add_option("--value", value);
  for (int i = 0;; ++i) {
    const CLI::Validator* check = nullptr;
    try {
      check = const_cast<CLI::Option&>(option).get_validator(i);
    } catch (const CLI::OptionNotFound&) {
      break;
    }
    copy->check(*check);
  }
  try {
    alone.parse(std::vector<std::string>{"--value=" + text});
  } catch (const CLI::ParseError& error) {
    return error.what();
  }
  return {};
}

bool hasRange(const CLI::Option& option) {
  try {
    return const_cast<CLI::Option&>(option).get_validator("number") != nullptr;
  } catch (const CLI::OptionNotFound&) {
    return false;
  }
}

TEST(NumberOptions, AllHaveARangeThatHelpShows) {
  int numbers = 0;
  forEveryOption([&](const std::string& verb, const CLI::Option& option) {
    if (!takesValues(option) || !takesNumber(option)) return;
    const std::string name = verb + " " + option.get_name();
    EXPECT_TRUE(hasRange(option)) << name;
    EXPECT_NE(option.get_type_name().find(" to "), std::string::npos) << name;
    ++numbers;
  });
  EXPECT_GE(numbers, 60);  // Of 13 verbs; fewer were not all looked at.
}

TEST(NumberOptions, RefuseWhatIsNotFiniteFarTooLargeOrEmpty) {
  forEveryOption([](const std::string& verb, const CLI::Option& option) {
    if (!hasRange(option)) return;
    const std::string type = option.get_type_name();
    const bool list = type.find("each ") != std::string::npos;
    for (const char* const text : {"nan", "-nan", "inf", "-inf", "1e308", "-1e308", "", " ", "x"}) {
      EXPECT_NE(refusalOf(option, text), "") << verb << ' ' << option.get_name() << ' ' << text;
      // In a list the others may be good.
      if (!list) continue;
      EXPECT_NE(refusalOf(option, std::string("1,") + text), "")
          << option.get_name() << ' ' << text;
    }
  });
}

TEST(NumberOptions, ListsCountTheirNumbersAndLookAtEach) {
  CLI::App app;
  std::string text;
  const CLI::Option& option = takesList(app.add_option("--at", text), 3, {.low = 0, .high = 9});
  EXPECT_EQ(refusalOf(option, "1,2,3"), "");
  EXPECT_EQ(refusalOf(option, "+1,2.5,9"), "");
  for (const char* bad : {"1,2", "1,2,3,4", "1,2,nan", "nan,2,3", "1,,3", "1,2,", "1,2,9.001"}) {
    EXPECT_NE(refusalOf(option, bad), "") << bad;
  }
}

TEST(Options, RefuseAnEmptyText) {
  int texts = 0;
  forEveryOption([&](const std::string& verb, const CLI::Option& option) {
    if (!takesValues(option)) return;
    EXPECT_NE(refusalOf(option, ""), "") << verb << ' ' << option.get_name();
    ++texts;
  });
  EXPECT_GE(texts, 150);
}

}  // namespace
}  // namespace relievo::batch
