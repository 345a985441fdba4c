// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/voice/voice_panel.h"

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>

namespace relievo {
namespace {

QSpinBox* numberField(const char* name, const QString& title, int low, int high, int step) {
  auto* field = new QSpinBox;
  field->setObjectName(QString::fromLatin1(name));
  field->setAccessibleName(title);
  field->setRange(low, high);
  field->setSingleStep(step);
  return field;
}

}  // namespace

VoicePanel::VoicePanel(QWidget* parent)
    : QWidget(parent),
      speaker_(new QComboBox),
      language_(new QComboBox),
      rate_(numberField("voiceRate", tr("Words a minute"), kSlowestSpeech, kFastestSpeech, 10)),
      volume_(numberField("voiceVolume", tr("Volume of speech, percent"), 0, 100, 10)),
      channel_(new QLabel),
      trial_(new QPushButton(tr("Try the voice"))),
      repeat_(new QPushButton(tr("Say it again"))) {
  setObjectName(QStringLiteral("voicePanel"));
  setProperty("foldedAtFirst", true);  // As the window knows it: for those who want it.
  speaker_->setObjectName(QStringLiteral("voiceSpeaker"));
  speaker_->setAccessibleName(tr("Who says what the hand meets"));
  speaker_->setToolTip(
      tr("With a voice of its own, the program says what the hand meets and what commands find, "
         "and the screen reader is not told the same."));
  speaker_->addItem(tr("The screen reader"), false);
  speaker_->addItem(tr("A voice of its own"), true);
  language_->setObjectName(QStringLiteral("voiceLanguage"));
  language_->setAccessibleName(tr("Language of the voice"));
  language_->addItem(tr("As the window"), QString());
  language_->addItem(QStringLiteral("English"), QStringLiteral("en"));
  language_->addItem(QStringLiteral("Deutsch"), QStringLiteral("de"));
  language_->addItem(QString::fromUtf8("हिन्दी"), QStringLiteral("hi"));
  rate_->setToolTip(tr("Exact with espeak-ng; other synthesizers have a scale of their own."));
  volume_->setSuffix(tr(" %"));
  channel_->setObjectName(QStringLiteral("voiceChannel"));
  channel_->setWordWrap(true);
  trial_->setObjectName(QStringLiteral("voiceTrial"));
  repeat_->setObjectName(QStringLiteral("voiceRepeat"));
  repeat_->setToolTip(tr("Say again what was said last (Ctrl+Alt+S)"));
  auto* form = new QFormLayout(this);
  form->setRowWrapPolicy(QFormLayout::WrapLongRows);
  form->addRow(tr("Spoken by"), speaker_);
  form->addRow(tr("Spoken language"), language_);
  form->addRow(tr("Words a minute"), rate_);
  form->addRow(tr("Volume"), volume_);
  form->addRow(channel_);
  form->addRow(trial_);
  form->addRow(repeat_);
  setSettings({});
  for (QComboBox* box : {speaker_, language_}) {
    connect(box, QOverload<int>::of(&QComboBox::currentIndexChanged), this, [this] {
      enableParts();
      Q_EMIT settingsChanged();
    });
  }
  for (QSpinBox* field : {rate_, volume_}) {
    connect(field, QOverload<int>::of(&QSpinBox::valueChanged), this, &VoicePanel::settingsChanged);
  }
  connect(trial_, &QPushButton::clicked, this, &VoicePanel::trialAsked);
  connect(repeat_, &QPushButton::clicked, this, &VoicePanel::repeatAsked);
  showChannel(OwnVoice::Channel::none);
}

VoiceSettings VoicePanel::settings() const {
  return {.own_voice = speaker_->currentData().toBool(),
          .language = language_->currentData().toString(),
          .words_per_minute = rate_->value(),
          .volume_percent = volume_->value()};
}

void VoicePanel::setSettings(const VoiceSettings& settings) {
  const QSignalBlocker a(speaker_), b(language_), c(rate_), d(volume_);
  speaker_->setCurrentIndex(settings.own_voice ? 1 : 0);
  language_->setCurrentIndex(qMax(0, language_->findData(settings.language)));
  rate_->setValue(settings.words_per_minute);
  volume_->setValue(settings.volume_percent);
  enableParts();
}

void VoicePanel::enableParts() {
  const bool own = speaker_->currentData().toBool();
  for (QWidget* part :
       std::initializer_list<QWidget*>{language_, rate_, volume_, trial_, repeat_}) {
    part->setEnabled(own);
  }
}

void VoicePanel::showChannel(OwnVoice::Channel channel) {
  const bool own = speaker_->currentData().toBool();
  switch (channel) {
    case OwnVoice::Channel::dispatcher:
      channel_->setText(tr("Speech Dispatcher speaks."));
      break;
    case OwnVoice::Channel::program:
      channel_->setText(tr("espeak-ng speaks; Speech Dispatcher does not answer."));
      break;
    case OwnVoice::Channel::none:
      channel_->setText(own ? tr("No voice can be heard.")
                            : tr("The program has no voice of its own now."));
      break;
  }
}

}  // namespace relievo
