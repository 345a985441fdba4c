// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/commands/button_commands.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

namespace relievo {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using enum ButtonCommand;

constexpr std::uint8_t kPlus = 0, kForward = 1, kCentre = 2, kMinus = 3;

class Buttons : public ::testing::Test {
 protected:
  /// Commands that are run while time goes on; offers and ticks are kept apart.
  std::vector<ButtonCommand> pass(double seconds) {
    std::vector<ButtonCommand> run;
    for (double end = now_ + seconds; now_ < end; now_ += 0.02) {
      for (const ButtonOutcome& outcome : buttons_.take(now_)) {
        if (outcome.kind == ButtonOutcome::Kind::run) run.push_back(outcome.command);
        if (outcome.kind == ButtonOutcome::Kind::offer) offers_.push_back(outcome.command);
        if (outcome.kind == ButtonOutcome::Kind::tick) ++ticks_;
      }
    }
    return run;
  }
  std::vector<ButtonCommand> hold(std::uint8_t button, double seconds) {
    buttons_.press(button, true, now_);
    std::vector<ButtonCommand> run = pass(seconds);
    buttons_.press(button, false, now_);
    const std::vector<ButtonCommand> after = pass(0.2);
    run.insert(run.end(), after.begin(), after.end());
    return run;
  }

  ButtonCommands buttons_;
  double now_ = 10;
  std::vector<ButtonCommand> offers_;
  int ticks_ = 0;
};

TEST_F(Buttons, ShortPressesChooseScaleAndPlace) {
  EXPECT_THAT(hold(kPlus, 0.2), ElementsAre(finer));
  EXPECT_THAT(hold(kMinus, 0.4), ElementsAre(coarser));
  EXPECT_THAT(hold(kCentre, 0.1), ElementsAre(where_am_i));
  EXPECT_THAT(hold(kCentre, 0.1), ElementsAre(where_am_i_long)) << "again within five seconds";
  pass(6);
  EXPECT_THAT(hold(kCentre, 0.1), ElementsAre(where_am_i));
  EXPECT_EQ(ticks_, 0);
}

TEST_F(Buttons, LongPressesActWhileHeldAndTick) {
  buttons_.press(kPlus, true, now_);
  EXPECT_THAT(pass(0.66), IsEmpty());
  EXPECT_THAT(pass(0.1), ElementsAre(say_detail)) << "not only on release";
  buttons_.press(kPlus, false, now_);
  EXPECT_THAT(pass(0.3), IsEmpty());
  EXPECT_EQ(ticks_, 1);
  EXPECT_THAT(hold(kMinus, 0.9), ElementsAre(whole));
  EXPECT_THAT(hold(kForward, 0.9), ElementsAre(toggle_beacon));
  EXPECT_THAT(hold(kCentre, 1.2), IsEmpty()) << "forces need a second and a half";
  EXPECT_THAT(hold(kCentre, 1.7), ElementsAre(toggle_forces));
}

TEST_F(Buttons, BetweenShortAndLongNothingIsDone) {
  EXPECT_THAT(hold(kPlus, 0.6), IsEmpty());
}

TEST_F(Buttons, ABounceIsNoSecondPress) {
  buttons_.press(kPlus, true, now_);
  buttons_.press(kPlus, false, now_ + 0.01);
  buttons_.press(kPlus, true, now_ + 0.02);
  EXPECT_THAT(pass(0.2), IsEmpty()) << "still down";
  buttons_.press(kPlus, false, now_);
  buttons_.press(kPlus, true, now_ + 0.005);
  buttons_.press(kPlus, false, now_ + 0.03);
  EXPECT_THAT(pass(0.3), ElementsAre(finer));
}

/// As a fast finger does on two presses, while the window is drawn: nobody asks between them.
TEST_F(Buttons, APressSoonAfterAnotherIsOneOfItsOwn) {
  buttons_.press(kPlus, true, now_);
  buttons_.press(kPlus, false, now_ + 0.15);
  buttons_.press(kPlus, true, now_ + 0.194);
  buttons_.press(kPlus, false, now_ + 0.345);
  now_ += 0.35;
  EXPECT_THAT(pass(0.3), ElementsAre(finer, finer));
  buttons_.press(kPlus, true, now_);
  buttons_.press(kPlus, false, now_ + 0.15);
  buttons_.press(kPlus, true, now_ + 0.155);
  buttons_.press(kPlus, false, now_ + 0.16);
  buttons_.press(kPlus, true, now_ + 0.5);
  buttons_.press(kPlus, false, now_ + 0.65);
  now_ += 0.66;
  EXPECT_THAT(pass(0.3), ElementsAre(finer, finer)) << "a bounce between them is none";
}

TEST_F(Buttons, ThePressOfADeviceThatIsGoneDoesNothingAndTheNextOneDoes) {
  buttons_.press(kCentre, true, now_);
  EXPECT_THAT(pass(1), IsEmpty());
  buttons_.forgetPresses();  // Nobody tells that it went up.
  EXPECT_THAT(pass(5), IsEmpty());
  EXPECT_THAT(hold(kCentre, 0.1), ElementsAre(where_am_i));
}

TEST_F(Buttons, AVeryShortPressIsNotLost) {
  buttons_.press(kPlus, true, now_);
  buttons_.press(kPlus, false, now_ + 0.03);
  EXPECT_THAT(pass(0.3), ElementsAre(finer));
}

TEST_F(Buttons, MoveModeGivesTheButtonsOtherMeanings) {
  EXPECT_THAT(hold(kForward, 0.2), ElementsAre(begin_move));
  EXPECT_TRUE(buttons_.moving());
  EXPECT_THAT(hold(kPlus, 0.2), ElementsAre(next_place));
  EXPECT_THAT(hold(kMinus, 0.2), ElementsAre(previous_place));
  EXPECT_THAT(hold(kMinus, 1), IsEmpty());
  EXPECT_THAT(hold(kForward, 0.2), ElementsAre(confirm_move));
  EXPECT_FALSE(buttons_.moving());
  hold(kForward, 0.2);
  EXPECT_THAT(hold(kForward, 1), ElementsAre(confirm_move, guide)) << "done, and on by the guide";
  EXPECT_FALSE(buttons_.moving());
  hold(kForward, 0.2);
  EXPECT_THAT(hold(kCentre, 0.2), ElementsAre(cancel_move));
  EXPECT_FALSE(buttons_.moving());
  hold(kForward, 0.2);
  EXPECT_THAT(hold(kCentre, 1.7), ElementsAre(toggle_forces)) << "stopping works everywhere";
  buttons_.setForcesOn(true);
  EXPECT_THAT(hold(kCentre, 1.7), ElementsAre(stop_forces)) << "what the loop has stopped is off";
}

TEST_F(Buttons, PushingTheGripAsideMovesOneStepPerPush) {
  buttons_.hand({50, 0, 0});
  EXPECT_THAT(pass(0.1), IsEmpty()) << "not in Move mode";
  hold(kForward, 0.2);
  buttons_.hand({5, 5, 0});
  buttons_.hand({26, 5, 0});
  EXPECT_THAT(pass(0.1), ElementsAre(move_right));
  buttons_.hand({40, 5, 0});
  EXPECT_THAT(pass(0.1), IsEmpty()) << "once, until it came back";
  buttons_.hand({6, 5, 0});
  buttons_.hand({6, -16, 0});
  EXPECT_THAT(pass(0.1), ElementsAre(move_down));
  buttons_.hand({6, 5, 0});
  buttons_.hand({-16, 10, 0});
  buttons_.hand({6, 5, 0});
  buttons_.hand({6, 30, 0});
  EXPECT_THAT(pass(0.1), ElementsAre(move_left, move_up));
}

TEST_F(Buttons, PlusAndMinusTogetherHelpAndDoNothingElse) {
  buttons_.press(kPlus, true, now_);
  pass(0.1);
  buttons_.press(kMinus, true, now_);
  EXPECT_THAT(pass(1.9), IsEmpty());
  EXPECT_THAT(pass(0.3), ElementsAre(help));
  EXPECT_THAT(pass(3), ElementsAre(restart_introduction));
  buttons_.press(kPlus, false, now_);
  pass(0.1);
  buttons_.press(kMinus, false, now_);
  EXPECT_THAT(pass(1), IsEmpty());
  EXPECT_THAT(hold(kPlus, 0.2), ElementsAre(finer)) << "and then as before";
}

TEST_F(Buttons, PlusAndMinusTogetherForAMomentSwitchBetweenLookAndTouch) {
  buttons_.press(kPlus, true, now_);
  pass(0.3);
  buttons_.press(kMinus, true, now_);
  EXPECT_THAT(pass(0.3), IsEmpty()) << "they may still be held for help";
  buttons_.press(kMinus, false, now_);
  EXPECT_THAT(pass(0.2), ElementsAre(switch_pointer)) << "counted from the second press";
  buttons_.press(kPlus, false, now_);
  EXPECT_THAT(pass(1), IsEmpty()) << "once";

  buttons_.press(kMinus, true, now_);
  buttons_.press(kPlus, true, now_);
  EXPECT_THAT(pass(0.9), IsEmpty());
  buttons_.press(kPlus, false, now_);
  buttons_.press(kMinus, false, now_);
  EXPECT_THAT(pass(1), IsEmpty()) << "neither a short press of both nor one for help";
  EXPECT_EQ(commandName(switch_pointer), "pointer_switch") << "as the window calls it";
}

TEST_F(Buttons, AfterHelpTheyAreTheVoicesForAWhile) {
  EXPECT_THAT(englishText(buttons_.help(now_)), testing::HasSubstr("Centre: say it again."));
  EXPECT_THAT(hold(kPlus, 0.2), ElementsAre(louder));
  EXPECT_THAT(hold(kMinus, 0.2), ElementsAre(softer));
  EXPECT_THAT(hold(kCentre, 0.2), ElementsAre(repeat));
  pass(15);
  EXPECT_THAT(hold(kPlus, 0.2), ElementsAre(louder)) << "each press begins the time anew";
  pass(15);
  EXPECT_THAT(hold(kMinus, 0.2), ElementsAre(softer));
  pass(21);
  EXPECT_THAT(hold(kMinus, 0.2), ElementsAre(coarser));
  EXPECT_THAT(hold(kCentre, 0.1), ElementsAre(where_am_i));
}

TEST_F(Buttons, WithoutAVoiceHelpSpeaksOfNoneAndTheButtonsStay) {
  buttons_.setVoice(false);
  EXPECT_THAT(englishText(buttons_.help(now_)),
              testing::Not(testing::HasSubstr("Centre: say it again.")));
  EXPECT_THAT(hold(kPlus, 0.2), ElementsAre(finer));
  EXPECT_THAT(hold(kCentre, 0.2), ElementsAre(where_am_i));
}

TEST_F(Buttons, ForwardEndsHelpAndAHeldCentreStillStopsForces) {
  buttons_.help(now_);
  EXPECT_THAT(hold(kForward, 0.2), IsEmpty());
  EXPECT_THAT(hold(kPlus, 0.2), ElementsAre(finer));
  buttons_.help(now_);
  buttons_.setForcesOn(true);
  EXPECT_THAT(hold(kCentre, 1.6), ElementsAre(stop_forces));
}

class OneButton : public Buttons {
 protected:
  OneButton() { buttons_ = ButtonCommands({.one_button = true, .scan_s = 1}); }
};

TEST_F(OneButton, WithoutAVoiceNothingOfItIsOffered) {
  buttons_.setVoice(false);
  hold(kCentre, 0.2);
  pass(30);
  EXPECT_THAT(offers_, testing::Not(testing::Contains(louder)));
  EXPECT_THAT(offers_, testing::Not(testing::Contains(repeat)));
  EXPECT_EQ(offers_.back(), help);
}

TEST_F(OneButton, OffersOneAfterTheOtherAndTakesTheLast) {
  EXPECT_THAT(hold(kCentre, 0.2), IsEmpty());
  pass(2);
  EXPECT_THAT(offers_, ElementsAre(where_am_i, finer, coarser));
  EXPECT_THAT(hold(kCentre, 0.2), ElementsAre(coarser));
  EXPECT_THAT(pass(10), IsEmpty());
  EXPECT_EQ(offers_.size(), 3U) << "the scan has ended";
}

TEST_F(OneButton, TakesRepeatAndVolumeInMoveModeToo) {
  for (const bool moving : {false, true}) {
    if (moving) buttons_.toggleMoving();
    pass(20);
    offers_.clear();
    hold(kPlus, 0.2);
    while (offers_.back() != repeat) pass(0.1);
    EXPECT_THAT(hold(kPlus, 0.2), ElementsAre(repeat));
    hold(kPlus, 0.2);
    while (offers_.back() != louder) pass(0.1);
    EXPECT_THAT(hold(kPlus, 0.2), ElementsAre(louder));
  }
}

TEST_F(OneButton, AScanThatNobodyTakesEnds) {
  hold(kPlus, 0.2);
  EXPECT_THAT(pass(20), IsEmpty());
  EXPECT_THAT(offers_, ElementsAre(where_am_i, finer, coarser, whole, begin_move, guide,
                                   toggle_forces, repeat, louder, softer, help))
      << "all that four buttons do, and the voice's (EN 301 549, 5.9)";
}

TEST_F(OneButton, WhereSomethingIsChosenItTakesGoesOnAndGoesBack) {
  hold(kPlus, 0.2);
  buttons_.setChoosing(true);
  EXPECT_THAT(hold(kPlus, 0.2), IsEmpty()) << "what was offered before is not taken";
  offers_.clear();
  pass(20);
  hold(kPlus, 0.2);
  EXPECT_THAT(pass(20), IsEmpty());
  EXPECT_THAT(offers_, ElementsAre(next, back, repeat, louder, softer, help, take, next, back,
                                   repeat, louder, softer, help));
  hold(kPlus, 0.2);
  EXPECT_THAT(hold(kPlus, 0.2), ElementsAre(take));
}

TEST_F(OneButton, HeldForASecondAndAHalfStopsForcesAndTakesNoOffer) {
  for (const bool moving : {false, true}) {
    if (moving) buttons_.toggleMoving();
    hold(kPlus, 0.2);
    offers_.clear();
    buttons_.press(kMinus, true, now_);
    EXPECT_THAT(pass(1.44), IsEmpty()) << "nothing of what was offered";
    EXPECT_THAT(pass(0.1), ElementsAre(stop_forces)) << "while it is held";
    EXPECT_THAT(pass(5), IsEmpty()) << "once";
    buttons_.press(kMinus, false, now_);
    EXPECT_THAT(pass(10), IsEmpty());
    EXPECT_THAT(offers_, IsEmpty()) << "the scan has ended";
  }
  EXPECT_EQ(ticks_, 2);
  EXPECT_THAT(hold(kCentre, 2), ElementsAre(stop_forces)) << "never on: also a second time";
}

TEST_F(OneButton, ASlowPressTakesWhatWasSaidWhenItBegan) {
  hold(kPlus, 0.2);
  pass(1);
  EXPECT_THAT(offers_, ElementsAre(where_am_i, finer));
  EXPECT_THAT(hold(kPlus, 1.3), ElementsAre(finer)) << "no other is offered meanwhile";
}

TEST_F(OneButton, TwoButtonsAtOnceAreOnePress) {
  buttons_.press(kPlus, true, now_);
  buttons_.press(kForward, true, now_ + 0.01);
  pass(0.1);
  buttons_.press(kPlus, false, now_);
  buttons_.press(kForward, false, now_ + 0.01);
  EXPECT_THAT(pass(0.5), IsEmpty());
  EXPECT_THAT(offers_, ElementsAre(where_am_i));
}

TEST_F(Buttons, HelpNamesEveryPressOfItsMode) {
  const auto all = [](std::string_view text, const std::vector<std::string>& parts) {
    for (const std::string& part : parts) {
      EXPECT_THAT(std::string(text), testing::HasSubstr(part));
    }
  };
  all(englishText(buttons_.help(now_)),
      {"Plus: finer; long: resolution and scale.", "Minus: coarser; long: whole",
       "Forward: move; long: marker.", "Centre: where am I; long: forces off or",
       "Plus and Minus: look or touch; for two seconds: help; for five: introduction."});
  buttons_.toggleMoving();
  all(englishText(buttons_.help(now_)),
      {"Plus: next bookmark.", "Minus: previous bookmark.",
       "Forward: done; long: guide along the outline.", "Centre: back; long: forces off or on.",
       "Plus and Minus for two seconds"});
  buttons_.setOptions({.one_button = true});
  all(englishText(buttons_.help(now_)),
      {"next bookmark, previous bookmark", "Hold for a second and a half: forces off."});
}

TEST_F(Buttons, EveryCommandHasANameAndWords) {
  for (int i = 1; i <= static_cast<int>(back); ++i) {
    EXPECT_FALSE(commandName(static_cast<ButtonCommand>(i)).empty());
    EXPECT_FALSE(englishText(messageOf(static_cast<ButtonCommand>(i))).empty());
  }
  EXPECT_EQ(commandName(finer), "finer");
  EXPECT_EQ(commandName(restart_introduction), "touchIntroduction");
}

TEST_F(Buttons, RandomPressesAlwaysEndAtRest) {
  std::mt19937 random(5);
  for (int i = 0; i < 20'000; ++i) {
    buttons_.press(static_cast<std::uint8_t>(random() % 6), random() % 2 == 0, now_);
    pass(0.02 * static_cast<double>(random() % 20));
  }
  for (std::uint8_t b = 0; b < 4; ++b) buttons_.press(b, false, now_);
  pass(0.2);
  EXPECT_THAT(pass(30), IsEmpty());
}

}  // namespace
}  // namespace relievo
