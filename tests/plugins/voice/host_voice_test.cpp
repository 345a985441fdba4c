// SPDX-License-Identifier: BSD-3-Clause
// What the window says goes to the voice, errors and questions of its strip as well; where no voice
// speaks, to the screen reader. What nobody asked for is told apart.
#include <gmock/gmock.h>

#include "app/host.h"
#include "core/message/catalogue.h"
#include "tests/ui/gui_fixture.h"
#include "ui/frame/announcer.h"

namespace relievo {
namespace {

using testing::ElementsAre;

class RecordingVoice : public Voice {
 public:
  bool isOn() const override { return speaks; }
  bool isSpeaking() const override { return false; }
  bool speak(const std::vector<Message>& sentences, SaidBecause why) override {
    return speak(QString::fromStdString(englishSpoken(sentences.front())), why);
  }
  bool speak(const QString& text, SaidBecause why) override {
    if (!speaks) return false;
    (why == SaidBecause::asked ? asked : noticed).push_back(text.toStdString());
    return true;
  }
  void hush() override {}
  void feel(const Probe& /*probe*/) override {}

  bool speaks = true;
  std::vector<std::string> asked, noticed;
};

class HostVoiceTest : public GuiTest {
 protected:
  HostVoiceTest() : host_(window()) { host_.setVoice(&voice_); }
  ~HostVoiceTest() override { host_.setVoice(nullptr); }
  QString told() const { return child<Announcer>("announcer")->text(); }

  WindowHost host_;
  RecordingVoice voice_;
};

TEST_F(HostVoiceTest, ErrorsAndMessagesOfTheStripAreSpoken) {
  window().messages().showError("Recording stopped.", "E401");
  EXPECT_THAT(voice_.asked, ElementsAre("Recording stopped."));
  EXPECT_EQ(window().message(), "Recording stopped. (E401)") << "the code is for eyes";
  window().showMessage("The object is 300 × 200 mm.");
  EXPECT_THAT(voice_.asked,
              ElementsAre("Recording stopped.", "The object is 30 centimetres by 20 centimetres."));
  EXPECT_EQ(told(), "") << "never by two voices";
}

TEST_F(HostVoiceTest, AQuestionIsSpokenWithTheKeyThatAnswersIt) {
  OpenRequest request;
  request.file = writeRelief();
  window().open(request);
  ASSERT_TRUE(waitFor([this] { return !voice_.asked.empty(); }));
  ASSERT_TRUE(waitFor([this] { return !window().message().isEmpty(); }));
  EXPECT_THAT(voice_.asked.back(), testing::HasSubstr("Ctrl+Return"))
      << window().message().toStdString();
}

TEST_F(HostVoiceTest, WhatNobodyAskedForIsNoticedAndNoMore) {
  Messages& messages = host_;
  messages.announce("Falcon connected.", SaidBecause::noticed);
  messages.showError("The disk is full.", "E401");
  messages.announce("Forces on.");
  EXPECT_THAT(voice_.noticed, ElementsAre("Falcon connected.", "The disk is full."));
  EXPECT_THAT(voice_.asked, ElementsAre("Forces on."));
  window().showMessage("Saved.");
  EXPECT_THAT(voice_.asked, ElementsAre("Forces on.", "Saved."));
}

TEST_F(HostVoiceTest, WithoutAVoiceTheScreenReaderIsToldTheSame) {
  voice_.speaks = false;
  window().messages().announce("Press depth 2.50 mm of hand");
  EXPECT_EQ(told(), "Press depth 2.5 millimetres of hand");
  window().messages().showError("Recording stopped.", "E401");
  EXPECT_EQ(told(), "Recording stopped.");
  host_.say({said<MessageId::ninth_top_left>()}, SaidBecause::asked);
  EXPECT_EQ(told(), "top left");
}

}  // namespace
}  // namespace relievo
