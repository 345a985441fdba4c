// SPDX-License-Identifier: BSD-3-Clause
// The voice against Debian's own speech-dispatcher with a module that records, against servers that
// are silent, refuse or end, and by espeak-ng where there is none.
#include "plugins/voice/own_voice.h"

#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/resource.h>

#include <QDir>
#include <QFile>
#include <QFileInfo>

#include "core/message/catalogue.h"
#include "core/region/probe.h"
#include "tests/plugins/plugin_fixture.h"
#include "tests/plugins/voice/speech_server.h"
#include "tests/plugins/voice/voice_servers.h"

namespace relievo {
namespace {

using test::AnsweringServer;
using test::eventually;
using test::FloodingServer;
using test::StrangeServer;

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
  /// A program that notes its runs and what it says, fails where there is a file "broken", and goes
  /// on for as long as there is a file "slow".
  SpeakingProgram scribe() const {
    write("scribe", "echo $$ >" + path("speaker") + "\necho run >>" + path("runs") +
                        "\ntext=$(cat)\n[ -e " + path("broken") +
                        " ] && exit 1\n[ -n \"$text\" ] && echo \"$text\" >>" + path("written") +
                        "\nwhile [ -e " + path("slow") + " ]; do sleep 0.05; done\nexit 0\n");
    return {"sh", {QString::fromStdString(path("scribe"))}};
  }
  QStringList lines(const char* name) const {
    QFile file(folder_.filePath(name));
    if (!file.open(QIODevice::ReadOnly)) return {};
    return QString::fromUtf8(file.readAll()).split('\n', Qt::SkipEmptyParts);
  }
  bool programHasEnded() const {
    return !QFile::exists("/proc/" + lines("speaker").value(0, "none"));
  }
  QStringList written() const { return lines("written"); }
  void write(const char* name, const std::string& text) const {
    QFile file(folder_.filePath(name));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(QByteArray::fromStdString(text));
  }
  void remove(const char* name) const { QFile::remove(folder_.filePath(name)); }
  void start(const QString& socket, const SpeakingProgram& program) {
    voice_ = std::make_unique<OwnVoice>(VoiceWays{.socket = socket.toStdString(),
                                                  .program = program,
                                                  .answer_ms = answer_ms_,
                                                  .retry_ms = retry_ms_});
    QObject::connect(voice_.get(), &OwnVoice::unheard, voice_.get(), [this](const Speech& speech) {
      unheard_ << speech.text;
      // As a host does.
      EXPECT_FALSE(voice_->speak(speech.text, SaidBecause::asked)) << "the screen reader is told";
    });
    QObject::connect(voice_.get(), &OwnVoice::channelChanged, voice_.get(),
                     [this] { told_channel_ = voice_->channel(); });
    QObject::connect(voice_.get(), &OwnVoice::failed, voice_.get(),
                     [this](const Message& why) { failures_.push_back(why); });
    voice_->setSettings(settings_);
  }
  bool say(const char* text) {
    return voice_->speak(QString::fromLatin1(text), SaidBecause::asked);
  }
  bool sayPlace() { return voice_->speak({said<MessageId::ninth_top_left>()}, SaidBecause::asked); }

  QTemporaryDir folder_;
  VoiceSettings settings_{.own_voice = true, .language = "en", .words_per_minute = 160};
  std::unique_ptr<OwnVoice> voice_;
  std::vector<Message> failures_;
  QStringList unheard_;  // And handed back.
  OwnVoice::Channel told_channel_ = OwnVoice::Channel::none;
  int answer_ms_ = 200'000;    // However busy the computer is.
  int retry_ms_ = 10'000'000;  // Never, unless the test is about it.
};

TEST_F(OwnVoiceTest, SpeechDispatcherHearsTextLanguageAndRateWithoutARestart) {
  RELIEVO_NEEDS_PROGRAM("speech-dispatcher");
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
  RELIEVO_NEEDS_PROGRAM("speech-dispatcher");
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
  RELIEVO_NEEDS_PROGRAM("espeak-ng");
  start(QString::fromStdString(path("nobody")), espeak());
  ASSERT_TRUE(sayPlace());
  EXPECT_TRUE(eventually([&] { return espeakHasSpoken(); }));
  EXPECT_EQ(voice_->channel(), OwnVoice::Channel::program);
  EXPECT_TRUE(failures_.empty());
}

TEST_F(OwnVoiceTest, ASilentServerIsGivenUpAndEspeakSaysWhatItWasGiven) {
  RELIEVO_NEEDS_PROGRAM("espeak-ng");
  const StrangeServer server(path("silent"));
  answer_ms_ = 100;
  start(QString::fromStdString(path("silent")), espeak());
  ASSERT_TRUE(sayPlace());
  EXPECT_EQ(voice_->channel(), OwnVoice::Channel::dispatcher) << "it may still answer";
  EXPECT_TRUE(eventually([&] { return espeakHasSpoken(); }));
  EXPECT_EQ(voice_->channel(), OwnVoice::Channel::program);
}

TEST_F(OwnVoiceTest, AServerThatEndsIsLeftForEspeak) {
  RELIEVO_NEEDS_PROGRAM("espeak-ng");
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
  EXPECT_EQ(failures_.size(), 1U);
}

TEST_F(OwnVoiceTest, AProgramThatFailsIsNoVoice) {
  start(QString::fromStdString(path("nobody")), {"false", {}});
  sayPlace();
  ASSERT_TRUE(eventually([&] { return !failures_.empty(); }));
  EXPECT_EQ(codeOf(failures_[0]), "E402");
}

TEST_F(OwnVoiceTest, SpeakingCopiesNothingOfThisProcess) {
  // After a copy of this process each page that is written to is a fault; the force loop would have
  // them.
  constexpr std::size_t kPages = 16384, kPageBytes = 4096;
  void* const room = ::mmap(nullptr, kPages * kPageBytes, PROT_READ | PROT_WRITE,
                            MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  ASSERT_NE(room, MAP_FAILED);
  ::madvise(room, kPages * kPageBytes, MADV_NOHUGEPAGE);
  const auto faults_of_writing = [&] {
    rusage before{}, after{};
    ::getrusage(RUSAGE_SELF, &before);
    for (std::size_t i = 0; i < kPages; ++i) {
      static_cast<volatile char*>(room)[i * kPageBytes] = static_cast<char>(i);
    }
    ::getrusage(RUSAGE_SELF, &after);
    return after.ru_minflt - before.ru_minflt;
  };
  faults_of_writing();
  start(QString::fromStdString(path("nobody")), scribe());
  say("Copied?");
  ASSERT_TRUE(eventually([&] { return written().size() == 1; }));
  EXPECT_LT(faults_of_writing(), static_cast<long>(kPages / 16));
  ::munmap(room, kPages * kPageBytes);
}

TEST_F(OwnVoiceTest, SwitchedOffItSaysNothing) {
  settings_.own_voice = false;
  start(QString::fromStdString(path("nobody")), scribe());
  EXPECT_FALSE(say("Off."));
  EXPECT_EQ(voice_->channel(), OwnVoice::Channel::none);
  EXPECT_FALSE(voice_->repeat());
  settings_.own_voice = true;
  voice_->setSettings(settings_);
  // Noticed: it does not cut what is being said.
  EXPECT_TRUE(voice_->speak(QStringLiteral("On."), SaidBecause::noticed));
  ASSERT_TRUE(eventually([&] { return written().contains("On."); }));
  EXPECT_EQ(written(), QStringList{"On."});
}

TEST_F(OwnVoiceTest, WhatNoVoiceSaysIsHandedBackAlsoAfterItLookedAgain) {
  retry_ms_ = 20;
  write("broken", "");
  start(QString::fromStdString(path("nobody")), scribe());
  EXPECT_TRUE(say("First.")) << "whether it can is not known yet";
  ASSERT_TRUE(eventually([&] { return !failures_.empty(); }));
  EXPECT_EQ(unheard_, QStringList{"First."});
  // Each look is a run of the program; until one succeeds, nothing is taken.
  EXPECT_TRUE(eventually([&] { return say("Later.") || lines("runs").size() >= 5; }));
  EXPECT_FALSE(say("Later."));
  EXPECT_EQ(voice_->channel(), OwnVoice::Channel::none);
  EXPECT_EQ(failures_.size(), 1U);
  remove("broken");
  ASSERT_TRUE(eventually([&] { return told_channel_ == OwnVoice::Channel::program; }));
  EXPECT_TRUE(say("Heard."));
  ASSERT_TRUE(eventually([&] { return !written().isEmpty(); }));
  EXPECT_EQ(written(), QStringList{"Heard."});
}

TEST_F(OwnVoiceTest, WithoutAVoiceRepeatHandsBackWhatWasSaidLast) {
  start(QString::fromStdString(path("nobody")), {"/no/such/program", {}});
  EXPECT_FALSE(voice_->repeat()) << "nothing was said";
  say("One.");
  ASSERT_TRUE(eventually([&] { return unheard_.size() == 1; }));
  EXPECT_TRUE(voice_->repeat());
  EXPECT_EQ(unheard_, QStringList({"One.", "One."}));
  EXPECT_FALSE(say("Two.")) << "the screen reader says it";
  EXPECT_TRUE(voice_->repeat());
  EXPECT_EQ(unheard_.last(), "Two.");
}

TEST_F(OwnVoiceTest, LookingForTheServerBeginsNoSentenceAgain) {
  retry_ms_ = 20;
  write("slow", "");
  start(QString::fromStdString(path("server")), scribe());
  say("A long sentence.");
  ASSERT_TRUE(eventually([&] { return written().size() == 1; }));
  const StrangeServer server(path("server"));
  int looks = 0;
  ASSERT_TRUE(eventually([&] {
    const int fd = server.acceptedNow();
    if (fd >= 0) ++looks;
    if (fd >= 0) ::close(fd);
    return looks >= 5;
  }));
  EXPECT_EQ(lines("runs").size(), 1) << "each run begins the sentence";
  EXPECT_EQ(voice_->channel(), OwnVoice::Channel::program);
  remove("slow");
}

TEST_F(OwnVoiceTest, AServerFoundLaterTakesOverAndTheProgramIsSilent) {
  retry_ms_ = 20;
  write("slow", "");
  start(QString::fromStdString(path("server")), scribe());
  say("A long sentence.");
  ASSERT_TRUE(eventually([&] { return written().size() == 1; }));
  AnsweringServer server(path("server"));
  ASSERT_TRUE(eventually([&] {
    server.heard();
    return told_channel_ == OwnVoice::Channel::dispatcher;
  })) << "the panel is told";
  EXPECT_FALSE(programHasEnded()) << "it may say its sentence to the end";
  EXPECT_TRUE(say("Two."));
  EXPECT_TRUE(eventually([&] { return programHasEnded(); })) << "there is one voice at a time";
  EXPECT_TRUE(eventually([&] { return server.heard().find("Two.") != std::string::npos; }));
  EXPECT_EQ(written(), QStringList{"A long sentence."});
}

TEST_F(OwnVoiceTest, WhatTheServerSaidToItsEndIsNotSaidAgainWhenItEnds) {
  AnsweringServer server(path("server"));
  start(QString::fromStdString(path("server")), scribe());
  say("One.");
  ASSERT_TRUE(eventually([&] {
    server.heard();
    return server.hasText();
  }));
  server.endAndGo();
  ASSERT_TRUE(eventually([&] { return told_channel_ == OwnVoice::Channel::program; }));
  // Noticed: it does not cut what is being said.
  voice_->speak(QStringLiteral("Two."), SaidBecause::noticed);
  ASSERT_TRUE(eventually([&] { return written().contains("Two."); }));
  EXPECT_EQ(written(), QStringList{"Two."});
}

TEST_F(OwnVoiceTest, SwitchedOffItSaysGoodByeToTheServer) {
  for (const bool answers_texts : {true, false}) {
    const std::string name = path(answers_texts ? "server" : "slow_server");
    AnsweringServer server(name);
    server.answers_texts = answers_texts;
    settings_.own_voice = true;
    start(QString::fromStdString(name), {"/no/such/program", {}});
    say("One.");
    const char* const last = answers_texts ? "One.\r\n.\r\n" : "SPEAK\r\n";
    ASSERT_TRUE(eventually([&] { return server.heard().ends_with(last); }));
    settings_.own_voice = false;
    voice_->setSettings(settings_);
    ASSERT_TRUE(eventually([&] { return server.heard().ends_with("QUIT\r\n"); }));
    EXPECT_NE(server.heard().find(answers_texts ? "CANCEL SELF\r\nQUIT\r\n"
                                                : "SPEAK\r\n\r\n.\r\nCANCEL SELF\r\nQUIT\r\n"),
              std::string::npos)
        << server.heard();
  }
}

TEST_F(OwnVoiceTest, SwitchedOffSpeechDispatcherIsSilent) {
  RELIEVO_NEEDS_PROGRAM("speech-dispatcher");
  test::SpeechDispatcher server;
  server.speakSlowly(true);
  ASSERT_TRUE(eventually([&] { return server.isListening(); })) << server.log().toStdString();
  start(server.socket(), {"/no/such/program", {}});
  ASSERT_TRUE(sayPlace());
  ASSERT_TRUE(eventually([&] { return server.said().size() == 1; }));
  EXPECT_TRUE(server.isSpeaking());
  voice_.reset();
  EXPECT_TRUE(eventually([&] { return !server.isSpeaking(); })) << "it was cut";
}

TEST_F(OwnVoiceTest, AServerThatSendsWithoutEndIsGivenUp) {
  for (const char* piece : {"x", "\r\n", "701-1\r\n701-1\r\n701 BEGIN\r\n", "299-more\r\n"}) {
    remove("flood");
    remove("written");
    FloodingServer server(path("flood"), piece);
    start(QString::fromStdString(path("flood")), scribe());
    server.begin();
    ASSERT_TRUE(say("One."));
    EXPECT_TRUE(eventually([&] { return written().size() == 1; })) << piece;
    EXPECT_EQ(voice_->channel(), OwnVoice::Channel::program);
    voice_.reset();
  }
}

TEST(EspeakChild, CancelledBeforeItIsKnownThatThereIsNoProgramNothingIsSaidOfIt) {
  EspeakChild speaker({"/no/such/program", {}});
  int failures = 0;
  QObject::connect(&speaker, &EspeakChild::failed, &speaker, [&failures] { ++failures; });
  speaker.speak("One.", {});
  EXPECT_EQ(failures, 0) << "never while it is asked";
  speaker.cancel();
  EXPECT_FALSE(speaker.isSpeaking());
  speaker.speak("Two.", {});
  ASSERT_TRUE(eventually([&] { return failures > 0; }));
  QCoreApplication::processEvents();
  EXPECT_EQ(failures, 1) << "of the second alone";
  EXPECT_FALSE(speaker.isSpeaking());
}

TEST_F(OwnVoiceTest, ManyWordsAndAnEndInTheMiddleAreSurvived) {
  RELIEVO_NEEDS_PROGRAM("espeak-ng");
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
