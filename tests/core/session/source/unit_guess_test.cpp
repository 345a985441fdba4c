// SPDX-License-Identifier: BSD-3-Clause
#include "core/session/source/unit_guess.h"

#include <gtest/gtest.h>

#include "core/io/import.h"
#include "tests/core/io/temporary_folder.h"

namespace relievo {
namespace {

ScanInfo infoOf(const std::string& format, const FilePoint& low, const FilePoint& high) {
  ScanInfo info;
  info.format = format;
  info.bounds = FileBounds{low, high};
  return info;
}

TEST(UnitGuess, ProjectedCoordinatesAreNeverTakenForMillimetres) {
  const ScanInfo utm = infoOf("PCD binary", {512022, 5403117, 226}, {512549, 5403502, 357});
  const UnitInUse unit = unitInUse(utm, std::nullopt, UnitSource::given);
  EXPECT_EQ(unit.unit, LengthUnit::m);
  EXPECT_EQ(unit.source, UnitSource::guessed);
  EXPECT_NE(englishText(unitWords(utm, unit).value()).find("map projection"), std::string::npos);
  EXPECT_EQ(unitInUse(infoOf("LAS 1.2", {-2e6, 3e5, 0}, {-1.999e6, 3.01e5, 9}), std::nullopt,
                      UnitSource::given)
                .source,
            UnitSource::guessed);
}

TEST(UnitGuess, AFlippedBitOrAHighShelfIsNoMapProjection) {
  for (const ScanInfo& info : {infoOf("PLY ascii", {0, 0, 0}, {3.1e6, 100, 10}),
                               infoOf("PLY ascii", {0, 0, 5e5}, {100, 100, 5.001e5}),
                               infoOf("PLY ascii", {0, 0, 0}, {2e5, 2e5, 1e4}),
                               infoOf("PLY ascii", {2e4, 0, 0}, {2.01e4, 100, 10})}) {
    const UnitInUse unit = unitInUse(info, std::nullopt, UnitSource::given);
    EXPECT_EQ(unit.unit, LengthUnit::mm);
    EXPECT_EQ(unit.source, UnitSource::assumed);
  }
}

TEST(UnitGuess, WhatIsStatedComesFirst) {
  ScanInfo utm = infoOf("LAS 1.2", {512022, 5403117, 226}, {512549, 5403502, 357});
  utm.unit = LengthUnit::us_ft;
  EXPECT_EQ(unitInUse(utm, std::nullopt, UnitSource::given).unit, LengthUnit::us_ft);
  const UnitInUse given = unitInUse(utm, LengthUnit::mm, UnitSource::remembered);
  EXPECT_EQ(given.unit, LengthUnit::mm);
  EXPECT_EQ(given.source, UnitSource::remembered);
  EXPECT_FALSE(unitWords(utm, given));
}

TEST(UnitGuess, WeakOnesStayMillimetresAndSayWhatIsLikelier) {
  struct Case {
    const char* format;
    FilePoint size;
    LengthUnit likely;
  };
  for (const Case& c :
       {Case{"OBJ", {8.7, 13.9, 11}, LengthUnit::cm}, Case{"OBJ", {1, 0.8, 0.7}, LengthUnit::m},
        Case{"PLY ascii", {24, 24, 1.1}, LengthUnit::mm},
        Case{"STL binary", {8.7, 13.9, 11}, LengthUnit::mm},
        Case{"PLY ascii", {300, 200, 40}, LengthUnit::mm},
        Case{"LAS 1.2 point format 0", {60, 40, 9}, LengthUnit::m},
        Case{"PCD ascii", {8000, 9000, 300}, LengthUnit::m}}) {
    const ScanInfo info = infoOf(c.format, {0, 0, 0}, c.size);
    EXPECT_EQ(guessUnit(info).unit, c.likely) << c.format << ' ' << c.size.x;
    EXPECT_FALSE(guessUnit(info).is_strong);
    const UnitInUse unit = unitInUse(info, std::nullopt, UnitSource::given);
    EXPECT_EQ(unit.unit, LengthUnit::mm);
    EXPECT_EQ(unit.source, UnitSource::assumed);
    const std::string words = englishText(unitWords(info, unit).value());
    const bool says_more = words.find("More likely") != std::string::npos;
    EXPECT_EQ(says_more, c.likely != LengthUnit::mm);
  }
}

TEST(UnitGuess, OfTheSharedScansOnlySurveysAreGuessed) {
  const std::filesystem::path data = test::sharedData();
  if (data.empty()) GTEST_SKIP() << "the shared scans are not here";
  for (const auto& [file, unit, source] :
       {std::tuple{"pcd/CSite3_orig-utm.pcd", LengthUnit::m, UnitSource::guessed},
        {"pcd/samp11-utm.pcd", LengthUnit::m, UnitSource::guessed},
        {"text/points_cloudcompare.xyz", LengthUnit::m, UnitSource::guessed},
        {"obj/armadillo.obj", LengthUnit::mm, UnitSource::assumed},
        {"ply/synthetic_coin.ply", LengthUnit::mm, UnitSource::assumed},
        {"e57/bunnyDouble.e57", LengthUnit::m, UnitSource::file}}) {
    const UnitInUse found =
        unitInUse(importScan(data / file).info, std::nullopt, UnitSource::given);
    EXPECT_EQ(found.unit, unit) << file;
    EXPECT_EQ(found.source, source) << file;
  }
}

}  // namespace
}  // namespace relievo
