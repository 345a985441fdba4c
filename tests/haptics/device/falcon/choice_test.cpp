// SPDX-License-Identifier: BSD-3-Clause
// Which of several Falcons is meant, with two that are emulated.
#include "haptics/device/falcon/choice.h"

#include <gmock/gmock.h>

#include <array>

#include "tests/haptics/device/falcon/falcon_fixture.h"

namespace relievo::falcon {
namespace {

using testing::HasSubstr;

const SeenFalcon kLeft{.serial = "A1", .port = "1-2"};
const SeenFalcon kRight{.serial = "B2", .port = "1-3.1"};
const SeenFalcon kTwin{.serial = "A1", .port = "2-1"};
const SeenFalcon kNameless{.serial = "", .port = "2-2"};

TEST(FalconChoice, AnIdNamesOneAndComesBack) {
  for (const char* id : {"falcon", "falcon:A1", "falcon:A1@1-2", "falcon:@1-2.4"}) {
    const auto choice = falconChoice(id);
    ASSERT_TRUE(choice) << id;
    EXPECT_EQ(idOf(*choice), id);
  }
  EXPECT_TRUE(falconChoice("falcon:0")->any()) << "as earlier versions kept it";
  EXPECT_EQ(falconChoice("falcon:a@b@1-2")->serial, "a@b") << "the last one begins the port";
  for (const char* id : {"falcon:", "falcon:@", "falcon:A1@", "falcons", "mouse"}) {
    EXPECT_FALSE(falconChoice(id)) << id;
  }
}

TEST(FalconChoice, ThePortIsNamedWhereTheSerialNumberIsNotEnough) {
  const std::array all{kLeft, kRight, kTwin, kNameless};
  EXPECT_EQ(idOf(shortestChoice(kRight, all)), "falcon:B2");
  EXPECT_EQ(idOf(shortestChoice(kLeft, all)), "falcon:A1@1-2");
  EXPECT_EQ(idOf(shortestChoice(kTwin, all)), "falcon:A1@2-1");
  EXPECT_EQ(idOf(shortestChoice(kNameless, all)), "falcon:@2-2");
  const SeenFalcon zero{.serial = "0", .port = "3-1"};
  EXPECT_EQ(idOf(shortestChoice(zero, {&zero, 1})), "falcon:0@3-1") << "falcon:0 means any";
}

TEST(FalconChoice, AnotherOneIsNeverTakenForTheOneThatIsMeant) {
  const std::array there{kRight, kTwin};
  EXPECT_EQ(FalconSearch({"B2", {}}).among(there).falcon, there.data());
  const FalconSearch::Found gone = FalconSearch({"A1", "1-2"}).among(there);
  EXPECT_EQ(gone.falcon, nullptr) << "same serial number, another port";
  EXPECT_EQ(gone.others, "A1 (USB 2-1), B2 (USB 1-3.1)");
  EXPECT_EQ(FalconSearch({"C3", {}}).among(there).falcon, nullptr);
  EXPECT_EQ(FalconSearch({{}, "1-2"}).among(there).falcon, nullptr);
}

TEST(FalconChoice, OfSeveralThatCouldBeMeantNoneIsTaken) {
  const std::array both{kLeft, kTwin};
  EXPECT_TRUE(FalconSearch().among(both).several);
  EXPECT_EQ(FalconSearch().among(both).falcon, nullptr);
  EXPECT_TRUE(FalconSearch({"A1", {}}).among(both).several);
  EXPECT_EQ(FalconSearch({"A1", "2-1"}).among(both).falcon, &both[1]);
}

TEST(FalconChoice, WhoeverAskedForAnyKeepsToTheOneThatWasThere) {
  FalconSearch search;
  search.keep(kLeft);
  EXPECT_EQ(search.among({&kRight, 1}).falcon, nullptr);
  const SeenFalcon moved{.serial = "A1", .port = "4-1"};
  EXPECT_EQ(search.among({&moved, 1}).falcon, &moved) << "another socket, the same Falcon";
  FalconSearch nameless;
  nameless.keep(kNameless);
  EXPECT_EQ(nameless.choice().port, "2-2") << "nothing else tells it from others";
}

/// Two that another program has started and homed.
class TwoFalconsTest : public test::FalconTest {
 protected:
  TwoFalconsTest() : FalconTest({.firmware_loaded = true, .homed = true}) {
    second_ = std::make_shared<emulator::SharedFalcon>(
        emulator::EmulatorOptions{.firmware_loaded = true, .homed = true});
  }
  void choose(const SeenFalcon& first, const SeenFalcon& second, const std::string& id) {
    auto bus = std::make_unique<emulator::InProcessBus>(
        std::vector<emulator::PlacedFalcon>{{first, emulated_}, {second, second_}}, clock_,
        falconChoice(id).value());
    device_ =
        std::make_unique<FalconDevice>(std::move(bus), [] { return relievo::test::madeImage(); });
  }
  std::uint64_t asked(const std::shared_ptr<emulator::SharedFalcon>& falcon) {
    return falcon->with([](auto& f) { return f.commandCount(); });
  }
  std::shared_ptr<emulator::SharedFalcon> second_;
};

TEST_F(TwoFalconsTest, TheOneThatWasChosenIsUsedAndTheOtherIsLeftAlone) {
  choose(kLeft, kRight, "falcon:B2");
  EXPECT_EQ(device_->info().id, "falcon:B2");
  begin();
  ASSERT_TRUE(becomes(LinkState::ready, 200));
  EXPECT_EQ(device_->info().name, "Falcon B2 (USB 1-3.1)");
  EXPECT_GT(asked(second_), 0U);
  EXPECT_EQ(asked(emulated_), 0U);
}

TEST_F(TwoFalconsTest, TwoOfTheSameSerialNumberAreToldApartByTheirPorts) {
  choose(kLeft, kTwin, "falcon:A1@2-1");
  begin();
  ASSERT_TRUE(becomes(LinkState::ready, 200));
  EXPECT_EQ(device_->info().name, "Falcon A1 (USB 2-1)");
  EXPECT_GT(asked(second_), 0U);
  EXPECT_EQ(asked(emulated_), 0U);
}

TEST_F(TwoFalconsTest, TheOneThatIsGoneIsNamedAndTheOtherIsNotUsed) {
  choose(kLeft, kRight, "falcon:A1");
  begin();
  ASSERT_TRUE(becomes(LinkState::ready, 200));
  falcon([](auto& f) { f.unplug(); });
  ASSERT_TRUE(becomes(LinkState::absent, 2000));
  const Message message = describe(device_->status());
  EXPECT_EQ(codeOf(message), "E305");
  EXPECT_THAT(englishText(message), HasSubstr("There is also B2 (USB 1-3.1), which is not used"));
  step(3000);
  EXPECT_EQ(device_->status().state, LinkState::absent);
  EXPECT_EQ(asked(second_), 0U) << "however long it is waited";
  falcon([](auto& f) { f.plugIn(); });
  EXPECT_TRUE(becomes(LinkState::homing, 5000)) << "and is taken up again";
}

TEST_F(TwoFalconsTest, OneThatIsNotThereIsNamedInWhatIsRefused) {
  choose(kLeft, kRight, "falcon:C3");
  try {
    device_->open();
    FAIL() << "another one was opened";
  } catch (const OpeningError& error) {
    EXPECT_EQ(error.presence(), Presence::absent);
    EXPECT_THAT(error.what(), HasSubstr("Falcon C3 was chosen and is not plugged in. There is "
                                        "A1 (USB 1-2), B2 (USB 1-3.1)"));
    EXPECT_EQ(englishSpoken(*error.message), "The chosen Falcon is not plugged in.");
  }
}

TEST_F(TwoFalconsTest, WithoutAChoiceNeitherIsUsed) {
  choose(kLeft, kRight, "falcon");
  EXPECT_THROW(device_->open(), OpeningError);
  begin();
  ASSERT_TRUE(becomes(LinkState::several, 200));
  EXPECT_THAT(englishText(describe(device_->status())), HasSubstr("A1 (USB 1-2), B2 (USB 1-3.1)"));
  EXPECT_EQ(asked(emulated_) + asked(second_), 0U);
  second_->with([](auto& f) { f.unplug(); });
  ASSERT_TRUE(becomes(LinkState::ready, 3000)) << "it is clear now";
  EXPECT_EQ(device_->info().id, "falcon:A1");
  second_->with([](auto& f) { f.plugIn(); });
  falcon([](auto& f) { f.unplug(); });
  ASSERT_TRUE(becomes(LinkState::absent, 2000)) << "the other one was never meant";
  EXPECT_EQ(asked(second_), 0U);
}

}  // namespace
}  // namespace relievo::falcon
