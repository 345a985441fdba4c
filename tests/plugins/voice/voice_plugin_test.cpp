// SPDX-License-Identifier: BSD-3-Clause
// The voice plugin as the application sees it: panel, command, keys that cut, E402, settings.
#include <gtest/gtest.h>

#include <QComboBox>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QTest>

#include "core/message/catalogue.h"
#include "tests/plugins/plugin_fixture.h"
#include "tests/plugins/voice/sound_server.h"
#include "tests/plugins/voice/speech_server.h"

namespace relievo {
namespace {

using test::eventually;

class VoicePluginTest : public ::testing::Test {
 protected:
  VoicePluginTest() { qputenv("SPEECHD_ADDRESS", "unix_socket:/no/such/socket"); }
  void load() {
    ASSERT_TRUE(loader_.load()) << loader_.errorString().toStdString();
    plugin_ = qobject_cast<Plugin*>(loader_.instance());
    ASSERT_NE(plugin_, nullptr);
    loader_.instance()->setProperty("speakingProgram", QStringList{"/no/such/program"});
    loader_.instance()->setProperty("answerMs", 200'000);  // However busy the computer is.
    plugin_->attach(host_);
  }
  void TearDown() override {
    if (plugin_ != nullptr) plugin_->detach();
    loader_.unload();
    qunsetenv("SPEECHD_ADDRESS");
  }
  template <class Widget>
  Widget* inPanel(const char* name) {
    auto* widget = host_.panels.at("Voice")->findChild<Widget*>(QString::fromLatin1(name));
    EXPECT_NE(widget, nullptr) << name;
    return widget;
  }
  void chooseOwnVoice() { inPanel<QComboBox>("voiceSpeaker")->setCurrentIndex(1); }

  test::PrivateHome home_;
  test::TestHost host_;
  QPluginLoader loader_{QStringLiteral(RELIEVO_BINARY_DIR "/plugins/voice_plugin.so")};
  Plugin* plugin_ = nullptr;
};

TEST_F(VoicePluginTest, LeavesSpeechToTheScreenReaderUnlessItIsAskedToSpeak) {
  load();
  ASSERT_NE(host_.voice, nullptr);
  EXPECT_FALSE(host_.voice->speak(QStringLiteral("Edge."), SaidBecause::asked));
  EXPECT_FALSE(host_.actions.at("repeatSpeech")->isEnabled());
  EXPECT_FALSE(inPanel<QSpinBox>("voiceRate")->isEnabled());
  plugin_->detach();
  EXPECT_EQ(host_.voice, nullptr) << "the host knows of no voice that is gone";
}

TEST_F(VoicePluginTest, SpeaksWhatTheHandMeetsInItsOwnLanguageAndRepeats) {
  RELIEVO_NEEDS_PROGRAM("speech-dispatcher");
  test::SpeechDispatcher server;
  ASSERT_TRUE(eventually([&] { return server.isListening(); })) << server.log().toStdString();
  qputenv("SPEECHD_ADDRESS", "unix_socket:" + server.socket().toUtf8());
  load();
  chooseOwnVoice();
  auto* language = inPanel<QComboBox>("voiceLanguage");
  language->setCurrentIndex(language->findData("de"));
  EXPECT_EQ(inPanel<QLabel>("voiceChannel")->text(), "Speech Dispatcher speaks.");
  host_.say({said<MessageId::place_in_the_air>(said<MessageId::ninth_top_left>())},
            SaidBecause::asked);
  ASSERT_TRUE(eventually([&] { return server.said().size() == 1; })) << server.log().toStdString();
  EXPECT_EQ(server.said().last(), "de|18.00|100.00|In der Luft: oben links.");
  language->setCurrentIndex(language->findData("en"));
  host_.actions.at("repeatSpeech")->trigger();
  ASSERT_TRUE(eventually([&] { return server.said().size() == 2; }));
  EXPECT_EQ(server.said().last(), "en|18.00|100.00|In the air: top left.");
  inPanel<QPushButton>("voiceTrial")->click();
  ASSERT_TRUE(eventually([&] { return server.said().size() == 3; }));
  EXPECT_TRUE(server.said().last().endsWith("This is the voice of relievo."));
}

TEST_F(VoicePluginTest, LouderAndSofterHoldFromTheNextWordsOnAndAreSaid) {
  load();
  EXPECT_FALSE(host_.actions.at("louderSpeech")->isEnabled());
  chooseOwnVoice();
  host_.actions.at("softerSpeech")->trigger();
  host_.actions.at("softerSpeech")->trigger();
  EXPECT_EQ(inPanel<QSpinBox>("voiceVolume")->value(), 50) << "by 3 dB each";
  host_.actions.at("louderSpeech")->trigger();
  EXPECT_EQ(host_.announcements,
            QStringList({"Volume 71 percent.", "Volume 50 percent.", "Volume 71 percent."}));
  for (int i = 0; i < 20; ++i) host_.actions.at("softerSpeech")->trigger();
  EXPECT_EQ(inPanel<QSpinBox>("voiceVolume")->value(), 10) << "who hears nothing finds no way back";
  for (int i = 0; i < 20; ++i) host_.actions.at("louderSpeech")->trigger();
  EXPECT_EQ(inPanel<QSpinBox>("voiceVolume")->value(), 100);
}

TEST_F(VoicePluginTest, IsNeverLouderInARoomThanTheRoomBears) {
  RELIEVO_NEEDS_PROGRAM("speech-dispatcher");
  RELIEVO_NEEDS_PROGRAM("pulseaudio");
  RELIEVO_NEEDS_PROGRAM("pactl");
  test::SoundServer sound;
  ASSERT_TRUE(eventually([&] { return sound.isReady(); })) << sound.log().toStdString();
  qputenv("PULSE_SERVER", sound.address());
  ASSERT_TRUE(sound.sendTo("ears"));
  test::SpeechDispatcher server;
  ASSERT_TRUE(eventually([&] { return server.isListening(); })) << server.log().toStdString();
  qputenv("SPEECHD_ADDRESS", "unix_socket:" + server.socket().toUtf8());
  load();
  const QByteArray state =
      R"({"own_voice":true,"volume_percent":70,"loudest_percent":80,"room_loudest_percent":40})";
  plugin_->restoreState(state);
  auto* volume = inPanel<QSpinBox>("voiceVolume");
  EXPECT_EQ(volume->value(), 40) << "nobody knows yet where it sounds";
  EXPECT_TRUE(eventually([&] { return volume->value() == 70; })) << "by headphones";
  host_.actions.at("louderSpeech")->trigger();
  EXPECT_EQ(volume->value(), 80);
  host_.actions.at("softerSpeech")->trigger();
  ASSERT_EQ(volume->value(), 57);
  server.speakSlowly(true);
  host_.voice->speak(QStringLiteral("A long story."), SaidBecause::asked);
  const auto told = [&] { return server.said().filter("A long story."); };
  ASSERT_TRUE(eventually([&] { return told().size() == 1; })) << server.log().toStdString();
  ASSERT_TRUE(sound.sendTo("room"));
  ASSERT_TRUE(eventually([&] { return told().size() == 2; })) << "it begins anew";
  EXPECT_EQ(volume->value(), 40);
  EXPECT_NE(told().at(0), told().at(1)) << "softer";
  server.speakSlowly(false);
  host_.actions.at("louderSpeech")->trigger();
  EXPECT_EQ(volume->value(), 40);
  plugin_->restoreState(state);
  EXPECT_EQ(volume->value(), 40) << "for the next visitor, too";
  ASSERT_TRUE(sound.sendTo("ears"));
  EXPECT_TRUE(eventually([&] {
    host_.actions.at("louderSpeech")->trigger();
    return volume->value() == 80;
  })) << "a louder voice is somebody's wish";
  qunsetenv("PULSE_SERVER");
}

TEST_F(VoicePluginTest, AnyKeyCutsWhatIsBeingSaid) {
  RELIEVO_NEEDS_PROGRAM("speech-dispatcher");
  test::SpeechDispatcher server;
  server.speakSlowly(true);
  ASSERT_TRUE(eventually([&] { return server.isListening(); })) << server.log().toStdString();
  qputenv("SPEECHD_ADDRESS", "unix_socket:" + server.socket().toUtf8());
  load();
  chooseOwnVoice();
  host_.voice->speak(QStringLiteral("A long story."), SaidBecause::asked);
  ASSERT_TRUE(eventually([&] { return server.said().size() == 1; })) << server.log().toStdString();
  host_.voice->speak(QStringLiteral("Noticed before the key."), SaidBecause::noticed);
  EXPECT_TRUE(server.isSpeaking());
  QTest::keyClick(host_.panels.at("Voice"), Qt::Key_Shift);
  EXPECT_TRUE(eventually([&] { return !server.isSpeaking(); })) << "it was cut";
  host_.voice->speak(QStringLiteral("Noticed after it."), SaidBecause::noticed);
  ASSERT_TRUE(eventually([&] { return server.said().size() == 2; }));
  EXPECT_TRUE(server.said().last().endsWith("|Noticed after it."));
}

TEST_F(VoicePluginTest, WithoutAnyVoiceItSaysE402AndTheScreenReaderIsTold) {
  load();
  chooseOwnVoice();
  host_.voice->speak(QStringLiteral("Edge."), SaidBecause::asked);
  ASSERT_TRUE(eventually([&] { return !host_.errors.isEmpty(); }));
  EXPECT_TRUE(host_.errors[0].startsWith("Speech is not available: the program /no/such/program"));
  EXPECT_TRUE(host_.errors[0].endsWith(" E402"));
  EXPECT_EQ(inPanel<QLabel>("voiceChannel")->text(), "No voice can be heard.");
  EXPECT_FALSE(host_.voice->speak(QStringLiteral("Edge."), SaidBecause::asked));
  EXPECT_EQ(host_.announcements, QStringList{"Edge."}) << "nobody had heard it";
  host_.actions.at("repeatSpeech")->trigger();
  EXPECT_EQ(host_.announcements, QStringList({"Edge.", "Edge."}));
}

TEST_F(VoicePluginTest, SentencesThatNobodyHeardAreHandedBack) {
  load();
  chooseOwnVoice();
  host_.voice->speak({said<MessageId::ninth_top_left>()}, SaidBecause::asked);
  EXPECT_TRUE(eventually([&] { return host_.announcements.contains("top left"); }));
}

TEST_F(VoicePluginTest, KeepsItsSettings) {
  load();
  chooseOwnVoice();
  inPanel<QSpinBox>("voiceRate")->setValue(300);
  const QByteArray state = plugin_->saveState();
  plugin_->restoreState({});
  EXPECT_EQ(inPanel<QSpinBox>("voiceRate")->value(), 220);
  plugin_->restoreState(state);
  EXPECT_EQ(inPanel<QSpinBox>("voiceRate")->value(), 300);
  EXPECT_EQ(inPanel<QComboBox>("voiceSpeaker")->currentIndex(), 1);
  EXPECT_TRUE(host_.actions.at("repeatSpeech")->isEnabled());
}

TEST_F(VoicePluginTest, EveryControlHasAName) {
  load();
  for (QWidget* widget : host_.panels.at("Voice")->findChildren<QWidget*>()) {
    if (widget->focusPolicy() == Qt::NoFocus || widget->objectName().startsWith("qt_")) continue;
    if (widget->window() != host_.panels.at("Voice")) continue;
    auto* button = qobject_cast<QPushButton*>(widget);
    EXPECT_FALSE(widget->accessibleName().isEmpty() &&
                 (button == nullptr || button->text().isEmpty()))
        << widget->objectName().toStdString();
  }
}

}  // namespace
}  // namespace relievo
