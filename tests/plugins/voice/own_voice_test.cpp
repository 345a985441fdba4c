// SPDX-License-Identifier: BSD-3-Clause
// The voice against Debian's own speech-dispatcher with a module that records, against servers that
// are silent, refuse or end, and by espeak-ng where there is none.
#include "plugins/voice/own_voice.h"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstring>
#include <QDir>
#include <QFileInfo>

#include "core/message/catalogue.h"
#include "core/region/probe.h"
#include "tests/plugins/plugin_fixture.h"
#include "tests/plugins/voice/speech_server.h"

namespace relievo {
namespace {

using test::eventually;

/// What listens and does nothing; or what ends each connection.
class StrangeServer {
 public:
  explicit StrangeServer(const std::string& path) : socket_(socket(AF_UNIX, SOCK_STREAM, 0)) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::strncpy(address.sun_path, path.c_str(), sizeof address.sun_path - 1);
    EXPECT_EQ(bind(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    EXPECT_EQ(listen(socket_, 4), 0);
  }
  ~StrangeServer() { close(socket_); }
  void acceptAndEnd() const { close(accept(socket_, nullptr, nullptr)); }

 private:
  int socket_;
};

class OwnVoiceTest : public ::testing::Test {
 protected:
  std::string path(const char* name) const { return folder_.filePath(name).toStdString(); }
  /// espeak-ng writes a file and needs no sound.
  SpeakingProgram espeak() const {
    return {"espeak-ng", {"-w", QString::fromStdString(path("said.wav"))}};
  }
  bool espeakHasSpoken() const {
    return QFileInfo(QString::fromStdString(path("said.wav"))).size() > 1000;
  }
  void start(const QString& socket, const SpeakingProgram& program) {
    voice_ = std::make_unique<OwnVoice>(
        VoiceWays{.socket = socket.toStdString(), .program = program, .answer_ms = answer_ms_});
    QObject::connect(voice_.get(), &OwnVoice::failed, voice_.get(),
                     [this](const Message& why) { failures_.push_back(why); });
    voice_->setSettings(settings_);
  }
  bool sayPlace() { return voice_->speak({said<MessageId::ninth_top_left>()}, SaidBecause::asked); }

  QTemporaryDir folder_;
  VoiceSettings settings_{.own_voice = true, .language = "en", .words_per_minute = 160};
  std::unique_ptr<OwnVoice> voice_;
  std::vector<Message> failures_;
  int answer_ms_ = 200'000;  // However busy the computer is.
};

TEST_F(OwnVoiceTest, SpeechDispatcherHearsTextLanguageAndRateWithoutARestart) {
  test::SpeechDispatcher server;
  ASSERT_TRUE(eventually([&] { return server.isListening(); })) << server.log().toStdString();
  start(server.socket(), {"/no/such/program", {}});
  EXPECT_EQ(voice_->channel(), OwnVoice::Channel::dispatcher);
  ASSERT_TRUE(sayPlace());
  ASSERT_TRUE(eventually([&] { return server.said().size() == 1; })) << server.log().toStdString();
  EXPECT_EQ(server.said().last(), "en|-11.00|100.00|top left");
  settings_.language = "de";
  settings_.words_per_minute = 220;
  settings_.volume_percent = 50;
  voice_->setSettings(settings_);
  EXPECT_TRUE(voice_->repeat());
  ASSERT_TRUE(eventually([&] { return server.said().size() == 2; }));
  EXPECT_EQ(server.said().last(), "de|18.00|0.00|oben links") << "the same, in another language";
  settings_.language = "hi";
  voice_->setSettings(settings_);
  ASSERT_TRUE(sayPlace());
  ASSERT_TRUE(eventually([&] { return server.said().size() == 3; }));
  EXPECT_EQ(server.said().last(), QString::fromUtf8("hi|18.00|0.00|ऊपर बाएँ"));
  EXPECT_TRUE(failures_.empty());
}

TEST_F(OwnVoiceTest, HushEndsWhatSpeechDispatcherSays) {
  test::SpeechDispatcher server;
  server.speakSlowly(true);
  ASSERT_TRUE(eventually([&] { return server.isListening(); })) << server.log().toStdString();
  start(server.socket(), {"/no/such/program", {}});
  ASSERT_TRUE(sayPlace());
  ASSERT_TRUE(eventually([&] { return server.said().size() == 1; }));
  EXPECT_TRUE(server.isSpeaking());
  voice_->hush();
  EXPECT_TRUE(eventually([&] { return !server.isSpeaking(); })) << "it was cut";
  // What was noticed is said when nothing else is.
  voice_->speak(QStringLiteral("Edge."), SaidBecause::noticed);
  EXPECT_TRUE(eventually([&] { return server.said().size() == 2; }));
  EXPECT_TRUE(server.said().last().endsWith("|Edge."));
}

TEST_F(OwnVoiceTest, WithoutAServerEspeakSaysIt) {
  start(QString::fromStdString(path("nobody")), espeak());
  ASSERT_TRUE(sayPlace());
  EXPECT_TRUE(eventually([&] { return espeakHasSpoken(); }));
  EXPECT_EQ(voice_->channel(), OwnVoice::Channel::program);
  EXPECT_TRUE(failures_.empty());
}

TEST_F(OwnVoiceTest, ASilentServerIsGivenUpAndEspeakSaysWhatItWasGiven) {
  const StrangeServer server(path("silent"));
  answer_ms_ = 100;
  start(QString::fromStdString(path("silent")), espeak());
  ASSERT_TRUE(sayPlace());
  EXPECT_EQ(voice_->channel(), OwnVoice::Channel::dispatcher) << "it may still answer";
  EXPECT_TRUE(eventually([&] { return espeakHasSpoken(); }));
  EXPECT_EQ(voice_->channel(), OwnVoice::Channel::program);
}

TEST_F(OwnVoiceTest, AServerThatEndsIsLeftForEspeak) {
  const StrangeServer server(path("ending"));
  start(QString::fromStdString(path("ending")), espeak());
  server.acceptAndEnd();
  ASSERT_TRUE(sayPlace());
  EXPECT_TRUE(eventually([&] { return espeakHasSpoken(); }));
  EXPECT_EQ(voice_->channel(), OwnVoice::Channel::program);
}

TEST_F(OwnVoiceTest, WithNeitherItSaysSoOnceAndSpeaksNoMore) {
  start(QString::fromStdString(path("nobody")), {"/no/such/program", {}});
  sayPlace();
  ASSERT_TRUE(eventually([&] { return !failures_.empty(); }));
  EXPECT_EQ(codeOf(failures_[0]), "E402");
  EXPECT_NE(englishText(failures_[0]).find("/no/such/program"), std::string::npos);
  EXPECT_FALSE(sayPlace()) << "the screen reader is told instead";
  EXPECT_FALSE(voice_->repeat());
  EXPECT_EQ(failures_.size(), 1U);
}

TEST_F(OwnVoiceTest, AProgramThatFailsIsNoVoice) {
  start(QString::fromStdString(path("nobody")), {"false", {}});
  sayPlace();
  ASSERT_TRUE(eventually([&] { return !failures_.empty(); }));
  EXPECT_EQ(codeOf(failures_[0]), "E402");
}

TEST_F(OwnVoiceTest, SwitchedOffItSaysNothing) {
  settings_.own_voice = false;
  start(QString::fromStdString(path("nobody")), espeak());
  EXPECT_FALSE(sayPlace());
  EXPECT_EQ(voice_->channel(), OwnVoice::Channel::none);
  EXPECT_FALSE(espeakHasSpoken());
}

TEST_F(OwnVoiceTest, ManyWordsAndAnEndInTheMiddleAreSurvived) {
  start(QString::fromStdString(path("nobody")), espeak());
  for (int i = 0; i < 30; ++i) {
    sayPlace();
    if (i % 3 == 0) voice_->hush();
    QCoreApplication::processEvents();
  }
  voice_.reset();
  EXPECT_TRUE(failures_.empty());
}

TEST(VoiceSettings, ComeBackAsTheyWereAndNonsenseIsTheDefault) {
  const VoiceSettings settings{
      .own_voice = true, .language = "hi", .words_per_minute = 300, .volume_percent = 40};
  EXPECT_EQ(voiceSettingsFromJson(jsonOf(settings)), settings);
  EXPECT_EQ(voiceSettingsFromJson("nonsense"), VoiceSettings());
  const VoiceSettings odd = voiceSettingsFromJson(
      R"({"own_voice": 7, "language": "xx", "words_per_minute": 9999, "volume_percent": -5})");
  EXPECT_FALSE(odd.own_voice);
  EXPECT_EQ(odd.language, "");
  EXPECT_EQ(odd.words_per_minute, 449);
  EXPECT_EQ(odd.volume_percent, 0);
}

}  // namespace
}  // namespace relievo
