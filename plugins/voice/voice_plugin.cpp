// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/voice/voice_plugin.h"

#include <algorithm>
#include <cmath>
#include <QAction>
#include <QApplication>
#include <QEvent>
#include <QKeySequence>
#include <utility>

#include "core/message/catalogue.h"
#include "core/region/window.h"
#include "ui/message/message_text.h"

namespace relievo {
namespace {

constexpr double kStepDb = 3;
constexpr int kLookMs = 100;

/// Three decibels louder or softer; both ways of speaking take a percentage of the amplitude.
int steppedVolume(int percent, bool louder) {
  constexpr double kDbPerDecade = 20;
  const double factor = std::pow(10.0, (louder ? kStepDb : -kStepDb) / kDbPerDecade);
  const int stepped = static_cast<int>(std::lround(factor * percent));
  return louder ? std::max(stepped, percent + 1) : std::min(stepped, percent - 1);
}

/// Where the voice speaks; what somebody has set on the plugin's object before is taken instead.
VoiceWays waysOf(const QObject& plugin) {
  VoiceWays ways{.socket = speechSocket()};
  QStringList program = plugin.property("speakingProgram").toStringList();
  if (!program.isEmpty()) {
    ways.program.name = program.takeFirst();
    ways.program.more = program;
  }
  const int answer_ms = plugin.property("answerMs").toInt();
  if (answer_ms > 0) ways.answer_ms = answer_ms;
  const int retry_ms = plugin.property("retryMs").toInt();
  if (retry_ms > 0) ways.retry_ms = retry_ms;
  return ways;
}

}  // namespace

VoicePlugin::~VoicePlugin() {
  detach();
}

void VoicePlugin::attach(Host& host) {
  host_ = &host;
  voice_ = std::make_unique<OwnVoice>(waysOf(*this));
  panel_ = new VoicePanel;
  host.controls.addPanel(tr("Voice"), panel_);  // The window owns it.
  repeat_action_ = addCommand({.name = QStringLiteral("repeatSpeech"),
                               .label = tr("&Repeat what was said"),
                               .key = QStringLiteral("Ctrl+Alt+S"),
                               .tip = tr("Say again what was said last (Ctrl+Alt+S)")});
  connect(repeat_action_, &QAction::triggered, this, &VoicePlugin::repeat);
  louder_action_ = addCommand({.name = QStringLiteral("louderSpeech"),
                               .label = tr("&Louder speech"),
                               .key = {},
                               .tip = tr("Raise the volume of the voice by 3 decibels")});
  connect(louder_action_, &QAction::triggered, this, [this] { changeVolume(true); });
  softer_action_ = addCommand({.name = QStringLiteral("softerSpeech"),
                               .label = tr("Sof&ter speech"),
                               .key = {},
                               .tip = tr("Lower the volume of the voice by 3 decibels")});
  connect(softer_action_, &QAction::triggered, this, [this] { changeVolume(false); });
  connect(panel_, &VoicePanel::settingsChanged, this, [this] {
    settings_ = panel_->settings();
    applySettings();
  });
  connect(panel_, &VoicePanel::trialAsked, this,
          [this] { voice_->speak({said<MessageId::voice_speaks>()}, SaidBecause::asked); });
  connect(panel_, &VoicePanel::repeatAsked, this, &VoicePlugin::repeat);
  connect(voice_.get(), &OwnVoice::channelChanged, this, [this] {
    if (panel_) panel_->showChannel(voice_->channel());
  });
  connect(voice_.get(), &OwnVoice::failed, this, [this](const Message& why) {
    host_->messages.showError(messageText(why), QString::fromStdString(codeOf(why)));
  });
  connect(voice_.get(), &OwnVoice::unheard, this, &VoicePlugin::handBack);
  connect(&host.view, &ShownWindow::windowShown, voice_.get(),
          [this](const std::shared_ptr<const RegionWindow>& window) {
            if (window) voice_->setScale(handMapping(*window).objectMmPerHandMm());
          });
  connect(&look_, &QTimer::timeout, this, &VoicePlugin::watchOutput);
  QCoreApplication::instance()->installEventFilter(this);
  host.messages.setVoice(voice_.get());
  applySettings();
}

QAction* VoicePlugin::addCommand(const Command& command) {
  auto* action = new QAction(command.label);
  action->setObjectName(command.name);
  if (!command.key.isEmpty()) action->setShortcut(QKeySequence(command.key));
  action->setToolTip(command.tip);
  action->setStatusTip(command.tip);
  action->setWhatsThis(tr("In the voice's language of now; with a voice of its own."));
  host_->controls.addAction(QStringLiteral("Touch"), action);
  return action;
}

void VoicePlugin::detach() noexcept {
  if (host_ == nullptr) return;
  QCoreApplication::instance()->removeEventFilter(this);
  host_->messages.setVoice(nullptr);
  look_.stop();
  disconnect(&look_, nullptr, this, nullptr);
  output_.reset();
  disconnect(&host_->view, nullptr, voice_.get(), nullptr);
  voice_->hush();
  voice_.reset();
  host_ = nullptr;
}

QByteArray VoicePlugin::saveState() const {
  return jsonOf(settings_);
}

void VoicePlugin::restoreState(const QByteArray& state) {
  settings_ = voiceSettingsFromJson(state);
  if (panel_) panel_->setSettings(settings_);
  applySettings();
}

void VoicePlugin::applySettings() {
  const bool watches =
      settings_.own_voice && settings_.room_loudest_percent < settings_.loudest_percent;
  if (!watches) {
    look_.stop();
    output_.reset();
  } else if (!output_) {
    output_ = std::make_unique<OutputWatch>();
    sounds_by_ = SoundOutput::unknown;
    look_.start(kLookMs);
  }
  if (settings_.volume_percent > loudestNow()) {
    lowered_from_ = sounds_by_ == SoundOutput::unknown ? settings_.volume_percent : 0;
    settings_.volume_percent = loudestNow();
    if (panel_) panel_->setSettings(settings_);
  }
  voice_->setSettings(settings_);
  // Without a voice of its own the screen reader repeats, if anyone.
  for (QAction* action : {repeat_action_.data(), louder_action_.data(), softer_action_.data()}) {
    if (action != nullptr) action->setEnabled(settings_.own_voice);
  }
  if (panel_) panel_->showChannel(voice_->channel());
}

void VoicePlugin::repeat() {
  if (!voice_->repeat()) host_->messages.say({said<MessageId::voice_nothing_to_repeat>()});
}

// Where nobody can tell, a room is taken for one.
int VoicePlugin::loudestNow() const {
  const bool in_the_ears = !output_ || sounds_by_ == SoundOutput::headphones;
  return in_the_ears ? settings_.loudest_percent : settings_.room_loudest_percent;
}

void VoicePlugin::watchOutput() {
  const SoundOutput now = output_->output();
  if (std::exchange(sounds_by_, now) == now) return;
  const int lowered_from = std::exchange(lowered_from_, 0);
  if (now == SoundOutput::headphones && lowered_from > 0) {
    settings_.volume_percent = lowered_from;  // It was not a room after all.
    applySettings();
    if (panel_) panel_->setSettings(settings_);
    return;
  }
  if (settings_.volume_percent <= loudestNow()) return;
  // What is being said goes on as loud as it began; the same words begin anew, softer.
  const bool was_speaking = voice_->isSpeaking();
  if (was_speaking) voice_->hush();
  applySettings();
  if (was_speaking) voice_->repeat();
}

void VoicePlugin::changeVolume(bool louder) {
  lowered_from_ = 0;
  const int now = settings_.volume_percent;
  // One that the panel has set lower does not become louder by "softer".
  const int least = louder ? kLeastVolume : std::min(now, kLeastVolume);
  settings_.volume_percent = std::clamp(steppedVolume(now, louder), least, loudestNow());
  if (panel_) panel_->setSettings(settings_);
  applySettings();
  host_->messages.say({said<MessageId::voice_volume>(settings_.volume_percent)});
}

void VoicePlugin::handBack(const Speech& speech) {
  if (speech.sentences.empty()) {
    host_->messages.announce(speech.text);
  } else {
    host_->messages.say(speech.sentences);
  }
}

bool VoicePlugin::eventFilter(QObject* watched, QEvent* event) {
  // A key that is a shortcut comes as an override only; both come before what the key does.
  const bool is_key =
      event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress;
  if (is_key && voice_) voice_->hush();
  return QObject::eventFilter(watched, event);
}

}  // namespace relievo
