// SPDX-License-Identifier: BSD-3-Clause
#include "ui/window/command_table.h"

#include <gtest/gtest.h>
#include <set>
#include <string>

#include "core/relief/look.h"

namespace relievo {
namespace {

const CommandRow& row(Command command) {
  return CommandTable::rows()[static_cast<std::size_t>(command)];
}

TEST(CommandTable, HasANameAndASentenceForEveryCommand) {
  std::set<std::string> names;
  for (const CommandRow& one : CommandTable::rows()) {
    ASSERT_NE(one.name, nullptr);
    EXPECT_TRUE(names.insert(one.name).second) << one.name << " stands twice";
    EXPECT_FALSE(std::string(one.text).empty()) << one.name;
    EXPECT_FALSE(std::string(one.tip).empty()) << one.name;
  }
}

TEST(CommandTable, GivesEveryKeyToOneCommand) {
  std::set<std::string> keys;
  for (const CommandRow& one : CommandTable::rows()) {
    for (const QString& key : QString::fromLatin1(one.keys).split('|', Qt::SkipEmptyParts)) {
      EXPECT_TRUE(keys.insert(key.toStdString()).second) << key.toStdString();
    }
  }
}

TEST(CommandTable, PutsOneButtonAtAPlaceOfTheToolBar) {
  std::set<int> places;
  for (const CommandRow& one : CommandTable::rows()) {
    if (one.tool == 0) continue;
    EXPECT_TRUE(places.insert(one.tool).second) << one.name;
    EXPECT_TRUE(one.icon.has_value()) << one.name;
  }
}

// The window finds them by counting on from the first.
TEST(CommandTable, HasAReliefImageAndColoursForEveryWordOfThem) {
  for (std::size_t i = 0; i < kReliefKindNames.size(); ++i) {
    EXPECT_EQ(row(commandAfter(Command::relief_lit, i)).name,
              "relief_" + std::string(kReliefKindNames[i]));
  }
  for (std::size_t i = 0; i < kColourMapNames.size(); ++i) {
    EXPECT_EQ(row(commandAfter(Command::colours_grey, i)).name,
              "colours_" + std::string(kColourMapNames[i]));
  }
  EXPECT_NE(row(commandAfter(Command::relief_lit, kReliefKindNames.size())).menu, Menu::relief);
  EXPECT_NE(row(commandAfter(Command::colours_grey, kColourMapNames.size())).menu, Menu::colours);
}

}  // namespace
}  // namespace relievo
