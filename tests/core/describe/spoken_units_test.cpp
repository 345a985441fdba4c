// SPDX-License-Identifier: BSD-3-Clause
// Texts of the window as one says them, in the three languages; what is no quantity stays.
#include "core/describe/spoken_units.h"

#include <gtest/gtest.h>

#include "ui/translations/message_languages.h"

namespace relievo {
namespace {

std::string english(std::string_view text) {
  return spokenUnits(messageLanguage("en"), text);
}
std::string german(std::string_view text) {
  return spokenUnits(messageLanguage("de"), text);
}
std::string hindi(std::string_view text) {
  return spokenUnits(messageLanguage("hi"), text);
}

TEST(SpokenUnits, SignsAreWordsAndNumbersAreRounded) {
  EXPECT_EQ(english("Press depth 2.50 mm of hand"), "Press depth 2.5 millimetres of hand");
  EXPECT_EQ(english("300 × 200 × 30 mm"), "30 centimetres by 20 centimetres by 3 centimetres");
  EXPECT_EQ(english("Height 38.8 mm, force 1 N."), "Height nearly 4 centimetres, force 1 newton.");
  EXPECT_EQ(english("Softened to 0.85 N/mm: swinging."),
            "Softened to 0.85 newtons per millimetre: swinging.");
  EXPECT_EQ(english("2.03 N"), "2 newtons");
  EXPECT_EQ(english("94.71 % and 3 %"), "95 percent and 3 percent");
  EXPECT_EQ(english("turned by 15°"), "turned by 15 degrees");
  EXPECT_EQ(english("after 1 s, at 986.4 Hz"), "after 1 second, at 1000 hertz");
  EXPECT_EQ(english("314.2 mm²"), "a little over 300 square millimetres");
  EXPECT_EQ(english("-2 mm"), "minus 2 millimetres");
  EXPECT_EQ(english("1.2 m (E401)"), "1.2 metres (E401)");
}

TEST(SpokenUnits, TheSecondOfTwoNumbersKeepsItsDigitsAndItsUnit) {
  EXPECT_EQ(english("Window at 312.0, 207.3 mm"), "Window at 312.0, 207.3 millimetres");
  EXPECT_EQ(english("from 3\u20131 mm"), "from 3\u20131 millimetre");
  EXPECT_EQ(english("turned by 15, 31°"), "turned by 15, 31 degrees");
  EXPECT_EQ(german("Fenster bei 312,0, 207,3 mm"), "Fenster bei 312,0, 207,3 Millimeter");
  EXPECT_EQ(hindi("312.0, 207.3 mm"), "312.0, 207.3 मिलीमीटर");
}

TEST(SpokenUnits, EachLanguageHasItsOwn) {
  EXPECT_EQ(german("Kraft 1,5 N, 2.000 mm breit"), "Kraft 1,5 Newton, 2 Meter breit");
  EXPECT_EQ(german("300 × 200 mm"), "30 Zentimeter mal 20 Zentimeter");
  EXPECT_EQ(german("38,8 mm"), "knapp 4 Zentimeter");
  EXPECT_EQ(german("nach 1 s und 2 s"), "nach 1 Sekunde und 2 Sekunden");
  EXPECT_EQ(hindi("बल 2.5 N।"), "बल 2.5 न्यूटन।");
  EXPECT_EQ(hindi("300 × 200 mm"), "30 सेंटीमीटर गुणा 20 सेंटीमीटर");
}

TEST(SpokenUnits, WhatIsNoQuantityStays) {
  for (const char* text :
       {"", "Resolution 2 of 4", "relief 30 mm.ply is saved", "scan3 m", "F5 switches", "Room 3N",
        "Ctrl+1", "5 mmx", "version 1.2.3 m", "2 samples", "mm", "%", "100 %1", "20 Meter"}) {
    EXPECT_EQ(english(text), text);
  }
  EXPECT_EQ(english("99999999999999999999 mm"), "99999999999999999999 mm") << "no one says it";
}

TEST(SpokenUnits, SaidOnceOrTwiceIsTheSame) {
  for (const char* text : {"Press depth 2.50 mm of hand", "300 × 200 × 30 mm", "94.71 %"}) {
    EXPECT_EQ(english(english(text)), english(text));
  }
}

}  // namespace
}  // namespace relievo
