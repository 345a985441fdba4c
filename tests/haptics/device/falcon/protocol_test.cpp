// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/device/falcon/protocol.h"

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace relievo::falcon {
namespace {

std::string text(const Frame& frame) {
  return {frame.begin(), frame.end()};
}

std::vector<Report> readAll(ReportReader& reader, std::string_view bytes) {
  std::vector<Report> reports;
  for (const char c : bytes) {
    if (const auto report = reader.take(static_cast<std::uint8_t>(c))) reports.push_back(*report);
  }
  return reports;
}

TEST(FalconCommand, HasTheBytesThatWereSeenOnWires) {
  EXPECT_EQ(text(encode({{}, true, red})), "<AAAAAAAAAAAAJA>");
  EXPECT_EQ(text(encode({{}, true, blue})), "<AAAAAAAAAAAAFA>");
  EXPECT_EQ(text(encode({{}, true, green})), "<AAAAAAAAAAAADA>");
  EXPECT_EQ(text(encode({{}, false, lights_off})), "<AAAAAAAAAAAAAA>");
  EXPECT_EQ(text(encode({{4095, 3906, 4034}, false, blue})), "<PPPACEPACMPAEA>");
  EXPECT_EQ(text(encode({{1000, -1000, -4095}, false, lights_off})), "<IODAIBMPBAAPAA>");
}

TEST(FalconCommand, NeverSendsMoreThanTheMotorsTake) {
  // Beyond 16 bits a force would turn round; beyond 4095 nobody knows.
  EXPECT_EQ(encode({{32767, -32768, 5000}, false, 0}), encode({{4095, -4095, 4095}, false, 0}));
}

TEST(FalconReport, IsReadFromALiteralAnswer) {
  ReportReader reader;
  // 0x41 + 0x7b: all homed; plus, forward and minus pressed.
  const std::vector<Report> reports = readAll(reader,
                                              "<IODAIBMPPPPA\xbc"
                                              "A>");
  ASSERT_EQ(reports.size(), 1U);
  EXPECT_EQ(reports[0].encoders, (std::array<std::int16_t, 3>{1000, -1000, 4095}));
  EXPECT_EQ(reports[0].homed, 7);
  EXPECT_EQ(reports[0].buttons, 0b1011);
  EXPECT_EQ(reader.malformed(), 0U);
}

TEST(FalconReport, OfAFragmentNothingIsUsed) {
  ReportReader reader;
  // Fourteen bytes: an old reader took homed = 7 and buttons = 13 from the bytes before.
  EXPECT_TRUE(readAll(reader, "<AAAAAAAAAAAA>").empty());
  EXPECT_EQ(reader.malformed(), 1U);
  EXPECT_TRUE(readAll(reader, "<AAAAAAAAAAAAAAA>").empty()) << "seventeen bytes";
  EXPECT_EQ(reader.malformed(), 2U);
  EXPECT_TRUE(readAll(reader, "<AAAAQAAAAAAAAA>").empty()) << "no nibble is 16";
  EXPECT_EQ(reader.malformed(), 3U);
}

TEST(FalconReport, IsFoundAgainAfterLostAndForeignBytes) {
  ReportReader reader;
  const std::string good = "<BAAAAAAAAAAAqA>";
  EXPECT_EQ(readAll(reader, "xyz" + good).size(), 1U);
  EXPECT_EQ(reader.malformed(), 1U) << "three foreign bytes are one damage";
  EXPECT_EQ(readAll(reader, "<BAAA" + good).size(), 1U);
  EXPECT_EQ(reader.malformed(), 2U);
  for (std::size_t lost = 0; lost < good.size(); ++lost) {
    std::string damaged = good;
    damaged.erase(lost, 1);
    const std::uint64_t before = reader.malformed();
    const std::vector<Report> reports = readAll(reader, damaged + good);
    ASSERT_EQ(reports.size(), 1U) << "byte " << lost;
    EXPECT_EQ(reports[0].encoders[0], 1);
    EXPECT_EQ(reader.malformed(), before + 1) << "byte " << lost;
  }
}

TEST(FalconReport, RandomBytesNeverMakeMoreThanAnswersCanHold) {
  std::mt19937 random(20261121);
  ReportReader reader;
  // Bytes near the alphabet, so that whole answers do occur.
  const std::string_view alphabet = "<>ABCDEFGHIJKLMNOPQ@q\xc0\xc1";
  std::size_t reports = 0;
  std::uniform_int_distribution<std::size_t> pick(0, alphabet.size() - 1);
  for (int i = 0; i < 2'000'000; ++i) {
    const bool any = i % 7 == 0;
    const auto byte = any ? static_cast<std::uint8_t>(random())
                          : static_cast<std::uint8_t>(alphabet[pick(random)]);
    if (const auto report = reader.take(byte)) {
      ++reports;
      ASSERT_LE(report->buttons, 15);
      ASSERT_LE(report->homed, 7);
    }
  }
  EXPECT_GT(reader.malformed(), 1000U);
  const std::string good = "<BAAAAAAAAAAAqA>";
  EXPECT_EQ(readAll(reader, good).size(), 1U) << "after " << reports << " answers by chance";
}

TEST(FalconLine, StatusIsTakenOutOfEveryPacketOfATransfer) {
  std::vector<std::uint8_t> transfer;
  std::vector<std::uint8_t> sent;
  for (int packet = 0; packet < 3; ++packet) {
    transfer.insert(transfer.end(), {0x11, 0x60});
    const int bytes = packet < 2 ? 62 : 5;
    for (int i = 0; i < bytes; ++i) {
      sent.push_back(static_cast<std::uint8_t>(100 * packet + i));
      transfer.push_back(sent.back());
    }
  }
  std::vector<std::uint8_t> payload(transfer.size());
  LineStatus status;
  payload.resize(stripStatus(transfer, payload, status));
  EXPECT_EQ(payload, sent);
  EXPECT_FALSE(status.damaged());
  EXPECT_TRUE(status.clear_to_send);
}

TEST(FalconLine, OfADamagedPacketAndThoseBeforeItNothingIsUsed) {
  const auto transfer = [](std::uint8_t second) {
    std::vector<std::uint8_t> bytes(2 * kPacketBytes + 5, 'B');
    bytes[0] = bytes[64] = bytes[128] = 0x01;
    bytes[1] = bytes[129] = 0x60;
    bytes[65] = second;
    bytes[130] = 'E';
    return bytes;
  };
  std::array<std::uint8_t, 256> payload{};
  for (const int bit : {0x02, 0x04, 0x08, 0x10}) {
    LineStatus status;
    EXPECT_EQ(stripStatus(transfer(static_cast<std::uint8_t>(0x60 | bit)), payload, status), 3U);
    EXPECT_EQ(payload[0], 'E');
    EXPECT_TRUE(status.damaged());
    EXPECT_EQ(status.overrun, bit == 0x02);
    EXPECT_EQ(status.parity, bit == 0x04);
    EXPECT_EQ(status.framing, bit == 0x08);
  }
  LineStatus status;
  EXPECT_EQ(stripStatus(transfer(0x60), payload, status), 127U);
}

TEST(FalconLine, APacketOfStatusAloneHasNoData) {
  std::array<std::uint8_t, 64> payload{};
  LineStatus status;
  EXPECT_EQ(stripStatus(std::array<std::uint8_t, 2>{0x01, 0x60}, payload, status), 0U);
  EXPECT_EQ(stripStatus(std::array<std::uint8_t, 1>{0x01}, payload, status), 0U);
  EXPECT_EQ(stripStatus({}, payload, status), 0U);
}

}  // namespace
}  // namespace relievo::falcon
