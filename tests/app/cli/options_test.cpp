// SPDX-License-Identifier: BSD-3-Clause
#include "app/options.h"

#include <gtest/gtest.h>

#include "core/base/error.h"

namespace relievo {
namespace {

TEST(WindowOptions, NothingGivenMeansTheStartPage) {
  const WindowOptions options = parseWindowOptions({});
  EXPECT_TRUE(options.files.empty());
  EXPECT_FALSE(options.safe_mode || options.help || options.version);
}

TEST(WindowOptions, EveryOptionIsReadInBothWaysOfWriting) {
  const WindowOptions options =
      parseWindowOptions({"a b.ply", "--unit", "us-ft", "--view=front", "--detail", "3",
                          "--region=1.5,-2,30,4e1", "--safe-mode"});
  EXPECT_EQ(options.files, std::vector<std::string>{"a b.ply"});
  EXPECT_EQ(options.unit, LengthUnit::us_ft);
  ASSERT_TRUE(options.view);
  EXPECT_EQ(options.view->name, "front");
  EXPECT_EQ(options.detail, 3);
  ASSERT_TRUE(options.region);
  EXPECT_EQ(options.region->x_mm, 1.5);
  EXPECT_EQ(options.region->y_mm, -2);
  EXPECT_EQ(options.region->height_mm, 40);
  EXPECT_TRUE(options.safe_mode);
}

TEST(WindowOptions, AnExhibitIsAlone) {
  EXPECT_EQ(parseWindowOptions({"--exhibit", "e.json"}).exhibit, "e.json");
  for (const char* other : {"a.ply", "--safe-mode", "--lang=de", "--detail=2"}) {
    EXPECT_THROW(parseWindowOptions({"--exhibit", "e.json", other}), ArgumentError) << other;
  }
}

TEST(WindowOptions, SeveralFilesAreOpenedTogether) {
  const WindowOptions options = parseWindowOptions({"one.ply", "--lang", "de", "two.ply"});
  EXPECT_EQ(options.files, (std::vector<std::string>{"one.ply", "two.ply"}));
  EXPECT_EQ(options.language, "de");
}

TEST(WindowOptions, BehindTwoDashesAllAreFiles) {
  const WindowOptions options = parseWindowOptions({"--lang", "de", "--", "-b.ply", "--help"});
  EXPECT_EQ(options.files, (std::vector<std::string>{"-b.ply", "--help"}));
  EXPECT_FALSE(options.help);
}

TEST(WindowOptions, WhatIsNotUnderstoodIsRefusedByName) {
  const std::vector<std::vector<std::string>> wrong{
      {"--colour"},
      {"--unit", "parsec"},
      {"--unit"},
      {"--view", "inside"},
      {"--detail", "two"},
      {"--detail", "0"},
      {"--region", "1"},
      {"--region", "1,2,3,4,5"},
      {"--region", "1,2,,4"},
      {"one.ply", "two.ply", "--unit", "m"},
  };
  for (const auto& arguments : wrong) {
    EXPECT_THROW(parseWindowOptions(arguments), ArgumentError) << arguments.front();
  }
}

TEST(WindowOptions, TheHelpNamesEveryOption) {
  for (const char* option :
       {"--unit", "--view", "--detail", "--region", "--exhibit", "--safe-mode", "--version"}) {
    EXPECT_NE(windowHelp().find(option), std::string::npos) << option;
  }
}

}  // namespace
}  // namespace relievo
