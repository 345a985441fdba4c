// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/voice/own_voice.h"

#include <chrono>
#include <QLocale>
#include <utility>

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
    : QObject(parent), ways_(std::move(ways)), program_(ways_.program) {
  connect(&program_, &EspeakChild::failed, this, &OwnVoice::leaveProgram);
  connect(&program_, &EspeakChild::ended, this, [this] {
    unheard_.reset();
    told_ = false;
  });
  retry_.setInterval(kRetryMs);
  connect(&retry_, &QTimer::timeout, this, [this] {
    program_failed_ = false;
    if (!dispatcher_) connectToDispatcher();
  });
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
  if (!settings.own_voice) {
    hush();
    dispatcher_.reset();
    retry_.stop();
    due_.stop();
  } else {
    program_failed_ = told_ = false;
    retry_.start();
    due_.start();
    connectToDispatcher();
  }
  Q_EMIT channelChanged();
}

void OwnVoice::connectToDispatcher() {
  dispatcher_ = std::make_unique<SsipClient>(ways_.socket, ways_.answer_ms);
  connect(dispatcher_.get(), &SsipClient::failed, this, &OwnVoice::leaveDispatcher);
  const auto heard = [this] {
    unheard_.reset();
    told_ = false;
  };
  connect(dispatcher_.get(), &SsipClient::begun, this, heard);
  connect(dispatcher_.get(), &SsipClient::ended, this, heard);
}

void OwnVoice::leaveDispatcher(const Message& /*why*/) {
  dispatcher_.release()->deleteLater();
  Q_EMIT channelChanged();
  // What it was given is said by the other.
  if (unheard_) utter(Speech(*unheard_));
}

void OwnVoice::leaveProgram(const Message& why) {
  program_failed_ = true;
  unheard_.reset();
  Q_EMIT channelChanged();
  if (!std::exchange(told_, true)) Q_EMIT failed(said<MessageId::voice_not_available>(why));
}

bool OwnVoice::speak(const std::vector<Message>& sentences, SaidBecause why) {
  if (channel() == Channel::none) return false;
  say({sentences, {}}, why);
  return true;
}

bool OwnVoice::speak(const QString& text, SaidBecause why) {
  if (channel() == Channel::none) return false;
  say({{}, text}, why);
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
  unheard_ = speech;
  const QString text = textOf(speech);
  if (dispatcher_) {
    dispatcher_->speak(text, styleOf(speech));
  } else if (!program_failed_) {
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
  if (channel() == Channel::none || !queue_.last()) return false;
  say(Speech(*queue_.last()), SaidBecause::asked);
  return true;
}

bool OwnVoice::isSpeaking() const {
  return (dispatcher_ && dispatcher_->isSpeaking()) || program_.isSpeaking();
}

QString OwnVoice::textOf(const Speech& speech) const {
  if (speech.sentences.empty()) return speech.text;
  return QString::fromStdString(
      spokenIn(messageLanguage(styleOf(speech).language), speech.sentences));
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
