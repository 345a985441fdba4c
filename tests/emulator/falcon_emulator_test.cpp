// SPDX-License-Identifier: BSD-3-Clause
// The emulated Falcon against the protocol's own bytes, written out here and shared with no driver;
// then every fault it can plant: an emulator that does not carry it out fails here, by the bytes.
#include "tests/emulator/falcon_emulator.h"

#include <gtest/gtest.h>

#include <string>

#include "tests/emulator/made_image.h"

namespace relievo::emulator {
namespace {

using Bytes = std::vector<std::uint8_t>;
constexpr std::int64_t kMs = 1'000'000;

class FalconBytes : public ::testing::Test {
 protected:
  explicit FalconBytes(EmulatorOptions options = {.firmware_loaded = true, .homed = true})
      : falcon_(options) {}

  /// A vendor request to the bridge: type 0x40, index 0, no data.
  void request(std::uint8_t number, std::uint16_t value) {
    const auto low = static_cast<std::uint8_t>(value), high = static_cast<std::uint8_t>(value >> 8);
    EXPECT_TRUE(falcon_.control({0x40, number, low, high, 0, 0, 0, 0}, {}, now_));
  }
  void runningSpeed() {
    request(9, 1);       // Latency 1 ms.
    request(3, 0x0002);  // 1.5 Mbaud.
  }
  /// What has come within so many milliseconds, without the two status bytes of each packet.
  std::string answer(int ms = 5) {
    std::string text;
    for (const std::int64_t end = now_ + ms * kMs; now_ < end; now_ += kMs / 10) {
      const auto packet = falcon_.bulkIn(now_);
      if (!packet) continue;
      EXPECT_GE(packet->size(), 2U);
      EXPECT_LE(packet->size(), 64U);
      status_ |= (*packet)[1];
      clear_to_send_ = ((*packet)[0] & 0x10U) != 0;
      text.append(packet->begin() + 2, packet->end());
    }
    return text;
  }
  bool send(const std::string& text) {
    return falcon_.bulkOut({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}, now_);
  }
  std::string ask(const std::string& frame, int ms = 5) {
    EXPECT_TRUE(send(frame));
    return answer(ms);
  }

  FalconEmulator falcon_;
  std::int64_t now_ = 1000 * kMs;
  int status_ = 0;  // Second status bytes, or'ed.
  bool clear_to_send_ = false;
};

TEST_F(FalconBytes, FramesAreUnderstoodAsWritten) {
  runningSpeed();
  struct Row {
    const char* frame;
    std::array<int, 3> motors;
    bool homing;
    int lights;
  };
  const std::array<Row, 6> rows{{{"<AAAAAAAAAAAAJA>", {0, 0, 0}, true, 8},
                                 {"<AAAAAAAAAAAAFA>", {0, 0, 0}, true, 4},
                                 {"<AAAAAAAAAAAADA>", {0, 0, 0}, true, 2},
                                 {"<AAAAAAAAAAAAAA>", {0, 0, 0}, false, 0},
                                 {"<IODAIBMPBAAPBA>", {1000, -1000, -4095}, true, 0},
                                 {"<PPPACEPACMPAEA>", {4095, 3906, 4034}, false, 4}}};
  for (const Row& row : rows) {
    EXPECT_EQ(ask(row.frame).size(), 16U) << row.frame;
    ASSERT_FALSE(falcon_.commands().empty());
    const SeenCommand& seen = falcon_.commands().back();
    EXPECT_EQ(seen.motors, row.motors) << row.frame;
    EXPECT_EQ(seen.homing, row.homing) << row.frame;
    EXPECT_EQ(seen.lights, row.lights) << row.frame;
  }
  EXPECT_EQ(falcon_.badCommands(), 0);
}

TEST_F(FalconBytes, AnswersCarryEncodersButtonsAndHomedArms) {
  runningSpeed();
  falcon_.body.hold({0, 0, 125});  // Encoders -200.10 each: 0xff38, lowest nibble first.
  falcon_.buttons = 0b0101;
  EXPECT_EQ(ask("<AAAAAAAAAAAAJA>"),
            "<IDPPIDPPIDPP\xb6"
            "A>")
      << "0x41 + 0x70 + 5";
  falcon_.buttons = 0;
  EXPECT_EQ(ask("<AAAAAAAAAAAAIA>"), "<IDPPIDPPIDPPAA>") << "not homing: nothing told of arms";
  falcon_.body.hold({30, 0, 125});  // 60.04, -616.72, 232.31.
  EXPECT_EQ(ask("<AAAAAAAAAAAAJA>"),
            "<MDAAHJNPIOAA\xb1"
            "A>");
}

TEST_F(FalconBytes, AnAnswerWaitsForTheLatencyTimer) {
  request(3, 0x0002);
  request(9, 16);
  answer(20);
  ASSERT_TRUE(send("<AAAAAAAAAAAAJA>"));
  const std::int64_t asked = now_;
  while (!falcon_.bulkIn(now_)) now_ += kMs / 10;
  EXPECT_GT(now_ - asked, 10 * kMs) << "60 Hz at the chip's default";
}

class FalconBootBytes : public FalconBytes {
 protected:
  FalconBootBytes() : FalconBytes({}) {}
  void beginHello() {
    request(9, 16);
    request(3, 0x4138);  // 9600 baud.
    request(1, 0x0100);  // DTR low, then high: into the boot loader.
    request(1, 0x0101);
  }
  const std::string hello_{"\x0a\x43\x0d"}, hello_answer_{"\x0a\x44\x2c\x0d"};
};

TEST_F(FalconBootBytes, HelloLockUploadAndStart) {
  EXPECT_EQ(ask("<AAAAAAAAAAAAJA>", 40), "") << "nothing runs yet";
  beginHello();
  EXPECT_EQ(ask(hello_, 40), hello_answer_);
  request(1, 0x0100);
  request(3, 0x0015);
  EXPECT_EQ(answer(40), "");
  EXPECT_TRUE(clear_to_send_) << "ready for the upload's baud rate";
  EXPECT_EQ(ask("A", 40), "A");
  const Bytes image = relievo::test::madeImage();
  const std::string text(image.begin(), image.end());
  EXPECT_EQ(text.substr(0, 2), "\xaa\x08");
  for (std::size_t at = 0; at < text.size(); at += 62) {
    ASSERT_EQ(ask(text.substr(at, 62), 20), text.substr(at, 62)) << "every byte comes back";
  }
  EXPECT_EQ(falcon_.uploads(), 1);
  runningSpeed();
  EXPECT_EQ(ask("<AAAAAAAAAAAAJA>", 20), "") << "it starts";
  answer(300);
  EXPECT_EQ(ask("<AAAAAAAAAAAAJA>").size(), 16U);
}

TEST_F(FalconBootBytes, FaultsOfTheBootLoaderAreCarriedOut) {
  falcon_.troubles.deaf_hellos = 1;
  beginHello();
  EXPECT_EQ(ask(hello_, 40), "") << "deaf";
  falcon_.troubles.late_hellos = 1;
  EXPECT_EQ(ask(hello_, 40), "") << "late ...";
  EXPECT_EQ(ask(hello_, 40), hello_answer_ + hello_answer_) << "... with the next one";
  request(1, 0x0100);
  request(3, 0x0015);
  ASSERT_EQ(ask("A", 40), "A");
  falcon_.troubles.wrong_echoes = 1;
  falcon_.troubles.wrong_echo_at = 2;
  EXPECT_EQ(ask("\xaa\x08", 20), "\xaa\x5d") << "the second byte echoed wrongly";
}

class FalconZeroBytes : public FalconBytes {
 protected:
  FalconZeroBytes() : FalconBytes({.leading_zero = true}) {}
};
TEST_F(FalconZeroBytes, AZeroMayComeBeforeTheAnswerToHello) {
  request(3, 0x4138);
  request(1, 0x0100);
  request(1, 0x0101);
  EXPECT_EQ(ask("\x0a\x43\x0d", 40), std::string("\0\x0a\x44\x2c\x0d", 5));
}

TEST_F(FalconBytes, FaultsOfTheLineAreCarriedOut) {
  runningSpeed();
  const std::string frame = "<AAAAAAAAAAAAJA>";
  falcon_.body.hold({0, 0, 125});
  const std::string whole = ask(frame);
  ASSERT_EQ(whole.size(), 16U);

  falcon_.troubles.lose_answer_bytes = 1;
  EXPECT_EQ(ask(frame), whole.substr(1)) << "a byte to the host is lost";
  falcon_.troubles.lose_command_bytes = 1;
  EXPECT_EQ(ask(frame), "") << "a byte to the device is lost";
  EXPECT_EQ(ask(frame), whole);
  falcon_.troubles.short_answers = 1;
  const std::string cut = ask(frame);
  EXPECT_EQ(cut.size(), 14U);
  EXPECT_EQ(cut.front(), '<');
  EXPECT_EQ(cut.back(), '>');
  EXPECT_EQ(status_ & 0x02, 0);
  falcon_.troubles.overruns = 1;
  EXPECT_EQ(ask(frame).size(), 15U);
  EXPECT_NE(status_ & 0x02, 0) << "the chip tells of it";
  falcon_.hold_answers_ns = 8 * kMs;
  EXPECT_EQ(ask(frame, 7), "") << "late ...";
  EXPECT_EQ(answer(5), whole) << "... and whole";
}

TEST_F(FalconBytes, FaultsOfTheDeviceAreCarriedOut) {
  runningSpeed();
  const std::string frame = "<AAAAAAAAAAAAJA>";
  falcon_.body.hold({0, 0, 125});
  const std::string before = ask(frame);

  falcon_.troubles.frozen_encoders = true;
  falcon_.body.hold({0, 0, 150});
  EXPECT_EQ(ask(frame), before) << "encoders stand still";
  falcon_.troubles.frozen_encoders = false;
  EXPECT_NE(ask(frame), before);

  falcon_.forgetCommands();
  falcon_.troubles.silent = true;
  EXPECT_EQ(ask(frame, 50), "");
  EXPECT_TRUE(falcon_.commands().empty());
  EXPECT_EQ(falcon_.unheeded().size(), 1U) << "it was on the wire";
  falcon_.troubles.silent = false;
  falcon_.troubles.failed_reads = 2;
  EXPECT_TRUE(falcon_.failsToRead() && falcon_.failsToRead() && !falcon_.failsToRead());
  falcon_.troubles.clogged = true;
  EXPECT_FALSE(send(frame)) << "the bridge takes nothing";
  falcon_.troubles.clogged = false;
  EXPECT_EQ(ask(frame).size(), 16U);

  falcon_.body.forgetHoming();
  const std::string lost = ask(frame);
  EXPECT_EQ(static_cast<unsigned char>(lost[13]), 0x41) << "no arm is homed any more";
  falcon_.body.beHomed();
  falcon_.body.forgetHoming(0b010);
  EXPECT_EQ(static_cast<unsigned char>(ask(frame)[13]), 0x41 + 0x50) << "only the right one";
  falcon_.unplug();
  EXPECT_FALSE(falcon_.plugged());
  falcon_.powerCycle();
  falcon_.plugIn();
  EXPECT_EQ(ask(frame, 50), "") << "its firmware is gone";
}

}  // namespace
}  // namespace relievo::emulator
