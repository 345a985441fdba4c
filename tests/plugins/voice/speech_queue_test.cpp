// SPDX-License-Identifier: BSD-3-Clause
// When what is said; in made-up time.
#include "plugins/voice/speech_queue.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/message/catalogue.h"

namespace relievo {
namespace {

using enum SaidBecause;

class SpeechQueueTest : public ::testing::Test {
 protected:
  void say(const char* text, SaidBecause why) { queue_.say({{}, text}, why); }
  /// Moves the hand for a time, at a speed, 60 times a second.
  void move(double seconds, double mm_per_s) {
    constexpr double kFrameS = 1.0 / 60;
    for (const double end = now_s_ + seconds; now_s_ < end;) {
      now_s_ += kFrameS;
      x_mm_ += mm_per_s * kFrameS;
      queue_.hand({x_mm_, 0, 0}, now_s_);
    }
  }
  /// Holds the hand where it is for a time, as well as a hand that trembles can.
  void tremble(double seconds, double hz, double mm) {
    constexpr double kFrameS = 1.0 / 60;
    for (const double end = now_s_ + seconds; now_s_ < end;) {
      now_s_ += kFrameS;
      queue_.hand({x_mm_ + mm * std::sin(2 * std::numbers::pi * hz * now_s_), 0, 0}, now_s_);
    }
  }
  QString taken(bool speaking = false) {
    const auto speech = queue_.take(now_s_, speaking);
    return speech ? speech->text : QString();
  }

  SpeechQueue queue_;
  double now_s_ = 100, x_mm_ = 0;
};

TEST_F(SpeechQueueTest, WhatWasAskedForIsSaidAtOnceAlsoWhileMovingAndSpeaking) {
  move(1, 50);
  say("One", asked);
  say("Two", asked);
  EXPECT_EQ(taken(true), "Two") << "the newest alone";
  EXPECT_EQ(taken(true), "");
}

TEST_F(SpeechQueueTest, WhatWasNoticedWaitsForTheHandToRest) {
  move(1, 50);
  say("One", noticed);
  say("Two", noticed);
  EXPECT_EQ(taken(), "");
  move(0.7, 0);
  EXPECT_EQ(taken(), "") << "people stop so shortly while they explore";
  move(0.2, 0);
  EXPECT_EQ(taken(true), "") << "not in the middle of something else";
  EXPECT_EQ(taken(), "Two");
  EXPECT_EQ(taken(), "");
}

TEST_F(SpeechQueueTest, ATremblingHandRests) {
  for (const double hz : {8.0, 10.0, 12.0}) {
    move(1, 50);
    say("One", noticed);
    tremble(0.6, hz, 0.3);
    EXPECT_EQ(taken(), "") << hz;
    tremble(0.6, hz, 0.3);
    EXPECT_EQ(taken(), "One") << hz;
  }
}

TEST_F(SpeechQueueTest, AMoveWhileNothingWasFeltIsNoRest) {
  move(1, 0);
  say("One", noticed);
  now_s_ += 3;
  x_mm_ += 40;
  move(0.1, 0);
  EXPECT_EQ(taken(), "");
  move(1, 0);
  EXPECT_EQ(taken(), "One");
}

TEST_F(SpeechQueueTest, WhatAnotherSaidIsWhatIsRepeated) {
  queue_.saidElsewhere({{}, "One"});
  EXPECT_EQ(queue_.last()->text, "One");
  EXPECT_EQ(taken(), "");
}

TEST_F(SpeechQueueTest, ASlowHandRestsAndASlowWayDoesNot) {
  move(1, 50);
  say("One", noticed);
  move(2, 8);
  EXPECT_EQ(taken(), "");
  move(1, 2);
  EXPECT_EQ(taken(), "One");
}

TEST_F(SpeechQueueTest, WhatWasAskedForTakesThePlaceOfWhatWaits) {
  move(1, 50);
  say("Noticed", noticed);
  say("Asked", asked);
  EXPECT_EQ(taken(), "Asked");
  move(2, 0);
  EXPECT_EQ(taken(), "");
}

TEST_F(SpeechQueueTest, HushForgetsWhatWaitsAndRepeatKnowsWhatWasSaid) {
  EXPECT_FALSE(queue_.last());
  say("One", asked);
  EXPECT_EQ(taken(), "One");
  say("Two", noticed);
  queue_.hush();
  move(2, 0);
  EXPECT_EQ(taken(), "");
  EXPECT_EQ(queue_.last()->text, "One");
}

TEST_F(SpeechQueueTest, TheVolumeIsNotWhatIsRepeated) {
  say("One", asked);
  EXPECT_EQ(taken(), "One");
  queue_.say({{said<MessageId::voice_volume>(60)}, {}}, asked);
  EXPECT_TRUE(queue_.take(now_s_, false));
  EXPECT_EQ(queue_.last()->text, "One");
}

}  // namespace
}  // namespace relievo
