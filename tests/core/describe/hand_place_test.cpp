// SPDX-License-Identifier: BSD-3-Clause
// Where the hand is, in words: against places and heights that are known.
#include "core/describe/hand_place.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "core/describe/named_place.h"
#include "core/message/message.h"

namespace relievo {
namespace {

using testing::ElementsAre;
using testing::IsSupersetOf;

/// On the dome of a relief of 300 x 200 mm, as script U3 tells it.
HandPlace onTheDome() {
  return {.object = {0, 0, 300, 200},
          .at = {90, 100, 30},
          .touching = true,
          .origin = CellStatus::measured,
          .name = "Dome",
          .detail = 1,
          .details = 4,
          .side_mm = 300,
          .spacing_mm = 2,
          .object_mm_per_hand_mm = 3.75};
}

std::vector<std::string> spoken(const std::vector<Message>& words) {
  std::vector<std::string> texts;
  for (const Message& word : words) texts.push_back(englishSpoken(word));
  return texts;
}

TEST(HandPlace, InShortItIsPlaceHeightAndName) {
  EXPECT_THAT(spoken(shortWords(onTheDome())),
              ElementsAre("Touching: middle left, 3 centimetres high.", "Bookmark: Dome."));
  EXPECT_EQ(englishText(shortWords(onTheDome()).front()), "Touching: middle left, height 30 mm.");
}

TEST(HandPlace, InFullItIsAlsoTheEdgesTheDetailAndTheScale) {
  EXPECT_THAT(
      spoken(longWords(onTheDome())),
      ElementsAre("Touching: middle left, 3 centimetres high.", "Bookmark: Dome.",
                  "9 centimetres from the left edge.", "10 centimetres from the bottom edge.",
                  "Measured here.", "Resolution 1 of 4, 30 centimetres wide.",
                  "One centimetre of hand: nearly 4 centimetres of relief.",
                  "Samples are 2 millimetres apart."));
}

TEST(HandPlace, EdgesAreTheObjectsAndToATenthOfAMillimetre) {
  HandPlace place = onTheDome();
  place.object = {-1000, 2000, 300, 200};
  place.at = {-912.7, 2102.3, 29.96};
  std::vector<std::string> texts;
  for (const Message& word : longWords(place)) texts.push_back(englishText(word));
  EXPECT_THAT(texts,
              IsSupersetOf({"Touching: middle left, height 30 mm.", "87.3 mm from the left edge.",
                            "102.3 mm from the bottom edge."}));
}

TEST(HandPlace, WhatWasNotMeasuredSaysWhy) {
  HandPlace place = onTheDome();
  place.name.clear();
  place.origin = CellStatus::interpolated;
  const std::vector<Message> words = shortWords(place);
  ASSERT_EQ(words.size(), 2U);
  EXPECT_EQ(englishSpoken(words[1]), "Not measured here.");
  EXPECT_EQ(englishText(words[1]), "Not measured here: interpolated.");
}

TEST(HandPlace, SteepGroundWasMeasured) {
  HandPlace place = onTheDome();
  place.name.clear();
  place.origin = CellStatus::steep;
  const std::vector<Message> words = shortWords(place);
  ASSERT_EQ(words.size(), 2U);
  EXPECT_EQ(englishSpoken(words[1]), "Measured here, but too steep to trust.");
}

TEST(HandPlace, TheGroundAndWhatIsBelowItHaveWordsOfTheirOwn) {
  HandPlace place = onTheDome();
  place.name.clear();
  place.at.z = -0.01;
  EXPECT_THAT(spoken(shortWords(place)), ElementsAre("Touching: middle left, on the ground."));
  EXPECT_EQ(englishText(shortWords(place).front()), "Touching: middle left, height 0 mm.");
  place.at.z = -5;
  EXPECT_THAT(spoken(shortWords(place)), ElementsAre("Touching: middle left, 5 millimetres deep."));
}

TEST(HandPlace, InTheAirThereIsNoHeightAndBesideNoPlace) {
  HandPlace place = onTheDome();
  place.name.clear();
  place.touching = false;
  EXPECT_THAT(spoken(shortWords(place)), ElementsAre("In the air: middle left."));
  place.at.x = 301;
  EXPECT_THAT(spoken(shortWords(place)), ElementsAre("Beside the relief."));
  place.at.x = 90;
  place.touching = true;
  place.origin = CellStatus::outside;
  EXPECT_THAT(spoken(shortWords(place)), ElementsAre("Beside the relief."));
}

TEST(NamedPlace, IsTheNearestWithinReachOrWithinItsWindow) {
  const RectMm object{0, 0, 300, 200};
  const std::vector<NamedRegion> places{
      {.name = "All of it", .region = {0, -50, 300, {}}},
      {.name = "Dome", .region = {50, 60, 80, {}}},   // Its middle is 90, 100.
      {.name = "Nose", .region = {85, 95, 20, {}}}};  // 95, 105.
  const auto at = [&](double x, double y) { return nameAt(places, object, {x, y, 0}, 5); };
  EXPECT_EQ(at(95, 105), "Nose");
  EXPECT_EQ(at(90.5, 100.5), "Dome") << "its middle is nearer";
  EXPECT_EQ(at(90, 139), "Dome");
  EXPECT_EQ(at(90, 141), "") << "beyond its window";
  EXPECT_EQ(at(150, 104), "All of it") << "of a whole view only its middle is a place";
  EXPECT_EQ(at(150, 106), "");
  EXPECT_EQ(nameAt({}, object, {95, 105, 0}, 5), "");
}

TEST(HandPlace, NoSentenceHasMoreThanADozenWords) {
  HandPlace place = onTheDome();
  place.at = {95.5, 106.1, 31.5};  // "a little over".
  place.side_mm = 315;
  place.spacing_mm = 2.1;
  place.object_mm_per_hand_mm = 3.15;
  for (const std::string& text : spoken(longWords(place))) {
    EXPECT_LE(1 + std::count(text.begin(), text.end(), ' '), 12) << text;
  }
  EXPECT_LE(shortWords(place).size(), 3U);
}

}  // namespace
}  // namespace relievo
