// SPDX-License-Identifier: BSD-3-Clause
// The client's end of Speech Dispatcher's protocol, against answers as version 0.11.4 gives them.
#include "plugins/voice/ssip.h"

#include <gmock/gmock.h>

#include <random>

namespace relievo {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using Event = SsipProtocol::Event;

class Ssip : public ::testing::Test {
 protected:
  /// What the client sends until it waits for nothing more, each command answered as it is sent.
  std::vector<std::string> exchange() {
    std::vector<std::string> sent;
    for (std::string bytes; !(bytes = protocol_.takeBytes()).empty();) {
      sent.push_back(bytes);
      protocol_.receive(answer(bytes));
    }
    return sent;
  }
  void speak(const std::string& text, const SpeechStyle& style = {}) {
    protocol_.speak(text, style);
    sent_ = exchange();
  }
  std::string answer(const std::string& bytes) {
    if (bytes == "SPEAK\r\n") return "230 OK RECEIVING DATA\r\n";
    if (bytes.ends_with("\r\n.\r\n")) {
      ++number_;
      return "225-" + std::to_string(number_) + "\r\n225 OK MESSAGE QUEUED\r\n";
    }
    if (bytes.starts_with("CANCEL")) return "210 OK CANCELED\r\n";
    return "200 OK\r\n";
  }
  void event(int number, const std::string& name, int code) {
    const std::string c = std::to_string(code), id = std::to_string(number);
    protocol_.receive(c + "-" + id + "\r\n" + c + "-1\r\n" + c + " " + name + "\r\n");
  }

  SsipProtocol protocol_;
  std::vector<std::string> sent_;
  int number_ = 0;
};

TEST_F(Ssip, SaysWhoItIsAndHowItSpeaksOnceAndThenOnlyTexts) {
  speak("One.", {.language = "de", .words_per_minute = 160, .volume_percent = 50});
  EXPECT_THAT(sent_, ElementsAre("SET SELF CLIENT_NAME user:relievo:touch\r\n",
                                 "SET SELF NOTIFICATION ALL ON\r\n", "SET SELF PRIORITY TEXT\r\n",
                                 "SET SELF LANGUAGE de\r\n", "SET SELF RATE -11\r\n",
                                 "SET SELF VOLUME 0\r\n", "SPEAK\r\n", "One.\r\n.\r\n"));
  event(1, "BEGIN", 701);
  event(1, "END", 702);
  EXPECT_THAT(protocol_.takeEvents(), ElementsAre(Event::begun, Event::ended));
  speak("Two.", {.language = "hi", .words_per_minute = 160, .volume_percent = 50});
  EXPECT_THAT(sent_, ElementsAre("SET SELF LANGUAGE hi\r\n", "SPEAK\r\n", "Two.\r\n.\r\n"));
}

TEST_F(Ssip, SendsACommandWhenTheOneBeforeWasAnswered) {
  protocol_.speak("One.", {});
  EXPECT_FALSE(protocol_.takeBytes().empty());
  EXPECT_TRUE(protocol_.isAwaiting());
  EXPECT_EQ(protocol_.takeBytes(), "");
  protocol_.receive("208 OK CLIE");
  EXPECT_EQ(protocol_.takeBytes(), "") << "half an answer is none";
  protocol_.receive("NT NAME SET\r\n");
  EXPECT_EQ(protocol_.takeBytes(), "SET SELF NOTIFICATION ALL ON\r\n");
}

TEST_F(Ssip, LinesThatBeginWithAFullStopHaveTwo) {
  speak(".5\n.\nrest");
  EXPECT_EQ(sent_.back(), "..5\r\n..\r\nrest\r\n.\r\n");
}

TEST_F(Ssip, NewerWordsCancelOlderOnesWhoseEndIsNoNews) {
  speak("One.");
  speak("Two.");
  EXPECT_THAT(sent_, ElementsAre("CANCEL SELF\r\n", "SPEAK\r\n", "Two.\r\n.\r\n"));
  event(1, "CANCELED", 703);
  EXPECT_THAT(protocol_.takeEvents(), IsEmpty());
  event(2, "BEGIN", 701);
  EXPECT_THAT(protocol_.takeEvents(), ElementsAre(Event::begun));
}

TEST_F(Ssip, OfManyThatWaitOnlyTheNewestIsSent) {
  protocol_.speak("One.", {});
  protocol_.speak("Two.", {});
  protocol_.speak("Three.", {});
  const std::vector<std::string> sent = exchange();
  EXPECT_EQ(std::count(sent.begin(), sent.end(), "SPEAK\r\n"), 1);
  EXPECT_EQ(sent.back(), "Three.\r\n.\r\n");
}

TEST_F(Ssip, WhatIsCancelledBeforeItWasSentIsNever) {
  speak("One.");
  protocol_.speak("Two.", {});
  protocol_.cancel();
  EXPECT_THAT(exchange(), ElementsAre("CANCEL SELF\r\n"));
  protocol_.cancel();
  EXPECT_THAT(exchange(), IsEmpty()) << "there is nothing to cancel";
}

TEST_F(Ssip, CancelledBetweenCommandAndTextItStillEndsTheText) {
  speak("One.");
  protocol_.speak("Two.", {});
  EXPECT_EQ(protocol_.takeBytes(), "CANCEL SELF\r\n");
  protocol_.receive("210 OK CANCELED\r\n");
  EXPECT_EQ(protocol_.takeBytes(), "SPEAK\r\n");
  protocol_.cancel();
  EXPECT_EQ(protocol_.takeBytes(), "");
  protocol_.receive("230 OK RECEIVING DATA\r\n");
  EXPECT_EQ(protocol_.takeBytes(), "Two.\r\n.\r\n");
  protocol_.receive("225-2\r\n225 OK MESSAGE QUEUED\r\n");
  EXPECT_EQ(protocol_.takeBytes(), "CANCEL SELF\r\n");
  event(2, "BEGIN", 701);
  EXPECT_THAT(protocol_.takeEvents(), IsEmpty());
}

TEST_F(Ssip, ALanguageThatThereIsNotIsNoEndAndARefusedTextIs) {
  speak("One.");
  protocol_.speak("Two.", {.language = "hi"});
  protocol_.takeBytes();
  protocol_.receive("210 OK CANCELED\r\n");
  EXPECT_EQ(protocol_.takeBytes(), "SET SELF LANGUAGE hi\r\n");
  protocol_.receive("409 ERR RATE TOO LOW\r\n");
  EXPECT_THAT(protocol_.takeEvents(), IsEmpty());
  EXPECT_EQ(protocol_.takeBytes(), "SPEAK\r\n");
  protocol_.receive("300 ERR INTERNAL\r\n");
  EXPECT_THAT(protocol_.takeEvents(), ElementsAre(Event::refused));
  EXPECT_EQ(protocol_.refusal(), "ERR INTERNAL");
}

TEST_F(Ssip, RatesAreWordsAMinuteOfEspeak) {
  EXPECT_EQ(ssipRate(80), -100);
  EXPECT_EQ(ssipRate(100), -78);
  EXPECT_EQ(ssipRate(160), -11);
  EXPECT_EQ(ssipRate(170), 0);
  EXPECT_EQ(ssipRate(220), 18);
  EXPECT_EQ(ssipRate(449), 100);
  EXPECT_EQ(ssipRate(9999), 100);
}

TEST_F(Ssip, KnowsWhetherTheServerMayTakeWhatComesForAText) {
  speak("One.");
  EXPECT_FALSE(protocol_.isTextDue());
  protocol_.speak("Two.", {});
  protocol_.takeBytes();
  protocol_.receive("210 OK CANCELED\r\n");
  EXPECT_FALSE(protocol_.isTextDue());
  EXPECT_EQ(protocol_.takeBytes(), "SPEAK\r\n");
  EXPECT_TRUE(protocol_.isTextDue());
  protocol_.receive("230 OK RECEIVING DATA\r\n");
  EXPECT_FALSE(protocol_.isTextDue());
}

TEST_F(Ssip, ALineWithoutEndAndAMebibyteWithoutAnAnswerAreAFlood) {
  SsipProtocol other;
  other.receive(std::string(65536, 'x'));
  EXPECT_FALSE(other.isFlooded());
  other.receive("x");
  EXPECT_TRUE(other.isFlooded());
  const std::string event = "700-1\r\n700-1\r\n700 INDEX MARK\r\n";
  for (std::size_t i = 0; i < 2'000'000 / event.size(); ++i) {
    if (i % 10'000 == 0) speak("One.");
    protocol_.receive(event);
  }
  EXPECT_FALSE(protocol_.isFlooded()) << "it answers now and then";
  for (std::size_t i = 0; i < 2'000'000 / event.size(); ++i) protocol_.receive(event);
  EXPECT_TRUE(protocol_.isFlooded());
}

TEST_F(Ssip, AnyBytesAreSurvived) {
  std::mt19937 random(402);  // NOLINT(cert-msc32-c,cert-msc51-cpp): the same in every run.
  std::uniform_int_distribution<int> byte(0, 255), size(0, 40);
  protocol_.speak("One.", {});
  for (int i = 0; i < 2000; ++i) {
    std::string bytes(static_cast<std::size_t>(size(random)), '\0');
    for (char& c : bytes) c = static_cast<char>(byte(random));
    if (i % 7 == 0) bytes += "\r\n230 \n225-\n225 \n701-\n701 \n";
    protocol_.receive(bytes);
    protocol_.takeBytes();
    protocol_.takeEvents();
  }
}

}  // namespace
}  // namespace relievo
