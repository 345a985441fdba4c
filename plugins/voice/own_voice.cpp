// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/voice/own_voice.h"

#include <chrono>
#include <QLocale>
#include <utility>

#include "core/describe/spoken_units.h"
#include "core/message/catalogue.h"
#include "core/region/probe.h"
#include "ui/translations/message_languages.h"

namespace relievo {
namespace {

double nowS() {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double>(now).count();
}

}  // namespace

OwnVoice::OwnVoice(VoiceWays ways, QObject* parent)
    : QObject(parent), ways_(std::move(ways)), program_(ways_.program), probe_(ways_.program) {
  connect(&program_, &EspeakChild::failed, this, &OwnVoice::leaveProgram);
  connect(&program_, &EspeakChild::ended, this, &OwnVoice::wasHeard);
  connect(&probe_, &EspeakChild::ended, this, [this] {
    program_failed_ = false;
    Q_EMIT channelChanged();
  });
  retry_.setInterval(ways_.retry_ms);
  connect(&retry_, &QTimer::timeout, this, &OwnVoice::lookAgain);
  // What was noticed waits for the hand to rest.
  constexpr int kLookMs = 100;
  due_.setInterval(kLookMs);
  connect(&due_, &QTimer::timeout, this, &OwnVoice::sayWhatIsDue);
}

OwnVoice::Channel OwnVoice::channel() const {
  if (!settings_.own_voice) return Channel::none;
  if (dispatcher_) return Channel::dispatcher;
  return program_failed_ ? Channel::none : Channel::program;
}

void OwnVoice::setSettings(const VoiceSettings& settings) {
  const bool switched = settings.own_voice != settings_.own_voice;
  settings_ = settings;
  if (!switched) return;
  if (settings.own_voice) {
    switchOn();
  } else {
    switchOff();
  }
  Q_EMIT channelChanged();
}

void OwnVoice::switchOn() {
  program_failed_ = told_ = false;
  retry_.start();
  due_.start();
  dispatcher_ = newClient();
}

void OwnVoice::switchOff() {
  hush();
  probe_.cancel();
  candidate_.reset();
  dispatcher_.reset();
  retry_.stop();
  due_.stop();
}

std::unique_ptr<SsipClient> OwnVoice::newClient() {
  auto made = std::make_unique<SsipClient>(ways_.socket, ways_.answer_ms);
  const SsipClient* client = made.get();
  connect(client, &SsipClient::failed, this,
          [this, client](const Message& why) { leaveClient(client, why); });
  connect(client, &SsipClient::begun, this, &OwnVoice::wasHeard);
  connect(client, &SsipClient::ended, this, &OwnVoice::wasHeard);
  connect(client, &SsipClient::answered, this, [this, client] {
    if (client != candidate_.get()) return;
    dispatcher_ = std::move(candidate_);
    Q_EMIT channelChanged();
  });
  return made;
}

void OwnVoice::lookAgain() {
  if (dispatcher_) return;
  if (!candidate_) candidate_ = newClient();
  if (program_failed_ && !probe_.isSpeaking()) probe_.speak({}, styleOf({}));
}

void OwnVoice::leaveClient(const SsipClient* client, const Message& why) {
  if (client == candidate_.get()) {
    candidate_.release()->deleteLater();
    return;
  }
  dispatcher_.release()->deleteLater();
  changeAfterFailure(Channel::dispatcher, why);
}

void OwnVoice::leaveProgram(const Message& why) {
  program_failed_ = true;
  changeAfterFailure(Channel::program, why);
}

void OwnVoice::changeAfterFailure(Channel left, const Message& why) {
  Q_EMIT channelChanged();
  if (channel() == Channel::none && !std::exchange(told_, true)) {
    Q_EMIT failed(said<MessageId::voice_not_available>(why));
  }
  // What it was given is said by another; what another was given is not begun again.
  if (unheard_ && given_to_ == left) utter(Speech(*unheard_));
}

void OwnVoice::wasHeard() {
  unheard_.reset();
  told_ = false;
}

bool OwnVoice::speak(const std::vector<Message>& sentences, SaidBecause why) {
  return take({sentences, {}}, why);
}

bool OwnVoice::speak(const QString& text, SaidBecause why) {
  return take({{}, text}, why);
}

bool OwnVoice::take(Speech speech, SaidBecause why) {
  if (channel() == Channel::none) {
    // The screen reader says it; this voice can repeat it.
    if (settings_.own_voice) queue_.saidElsewhere(std::move(speech));
    return false;
  }
  say(std::move(speech), why);
  return true;
}

void OwnVoice::say(Speech speech, SaidBecause why) {
  queue_.say(std::move(speech), why);
  sayWhatIsDue();
}

void OwnVoice::sayWhatIsDue() {
  if (const auto speech = queue_.take(nowS(), isSpeaking())) utter(*speech);
}

void OwnVoice::utter(const Speech& speech) {
  given_to_ = channel();
  if (given_to_ == Channel::none) {
    unheard_.reset();
    Q_EMIT unheard(speech);
    return;
  }
  unheard_ = speech;
  const QString text = textOf(speech);
  if (given_to_ == Channel::dispatcher) {
    program_.cancel();  // One voice at a time.
    dispatcher_->speak(text, styleOf(speech));
  } else {
    program_.speak(text, styleOf(speech));
  }
}

void OwnVoice::hush() {
  queue_.hush();
  unheard_.reset();
  if (dispatcher_) dispatcher_->cancel();
  program_.cancel();
}

void OwnVoice::feel(const Probe& probe) {
  const double scale = 1 / object_mm_per_hand_mm_;
  queue_.hand({scale * probe.hip.x, scale * probe.hip.y, scale * probe.hip.z}, nowS());
}

bool OwnVoice::repeat() {
  if (!settings_.own_voice || !queue_.last()) return false;
  say(Speech(*queue_.last()), SaidBecause::asked);
  return true;
}

bool OwnVoice::isSpeaking() const {
  return (dispatcher_ && dispatcher_->isSpeaking()) || program_.isSpeaking();
}

QString OwnVoice::textOf(const Speech& speech) const {
  if (speech.sentences.empty()) return speech.text;
  const MessageLanguage& language = messageLanguage(styleOf(speech).language);
  return QString::fromStdString(spokenUnits(language, spokenIn(language, speech.sentences)));
}

SpeechStyle OwnVoice::styleOf(const Speech& speech) const {
  // A text is in the window's language, whatever the voice's own is.
  const bool is_windows = speech.sentences.empty() || settings_.language.isEmpty();
  const std::string tag = (is_windows ? QLocale().name() : settings_.language).toStdString();
  return {.language = std::string(messageLanguage(tag).tag),
          .words_per_minute = settings_.words_per_minute,
          .volume_percent = settings_.volume_percent};
}

}  // namespace relievo
