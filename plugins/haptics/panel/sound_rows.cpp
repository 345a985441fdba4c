// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/haptics/panel/sound_rows.h"

#include <QCheckBox>
#include <QFormLayout>
#include <QSignalBlocker>
#include <QSpinBox>

#include "plugins/haptics/panel/panel_widgets.h"

namespace relievo {

SoundRows::SoundRows(QObject* parent)
    : QObject(parent),
      on_(named(new QCheckBox(tr("Sounds of touch")), "touchSoundsBox", tr("Sounds of touch"))),
      volume_(named(new QSpinBox, "touchSoundsVolume", tr("Volume of the sounds in percent"))),
      felt_(named(new QCheckBox(tr("Felt patterns")), "feltPatternsBox", tr("Felt patterns"))) {
  on_->setToolTip(tr("Hear what the hand meets, while it touches (Ctrl+Alt+A)."));
  volume_->setRange(0, 100);
  volume_->setSingleStep(kVolumeStep);
  volume_->setSuffix(tr(" %"));
  volume_->setToolTip(tr("Of the sounds of touch; speech has a volume of its own."));
  felt_->setToolTip(
      tr("Taps of the grip: one is yes, two not measured, three the edge. Only while forces are "
         "on."));
  connect(felt_, &QCheckBox::toggled, this, &SoundRows::changed);
  connect(on_, &QCheckBox::toggled, this, &SoundRows::changed);
  connect(volume_, qOverload<int>(&QSpinBox::valueChanged), this, &SoundRows::changed);
}

void SoundRows::addTo(QFormLayout* form) {
  form->addRow(on_);
  addLabelled(form, tr("Volume"), volume_, volume_);
  form->addRow(felt_);
}

SoundSettings SoundRows::sound() const {
  return {.on = on_->isChecked(), .volume_percent = volume_->value()};
}

bool SoundRows::feltPatterns() const {
  return felt_->isChecked();
}

void SoundRows::set(const TouchSettings& settings) {
  const QSignalBlocker on(on_), volume(volume_), felt(felt_);
  on_->setChecked(settings.sound.on);
  volume_->setValue(settings.sound.volume_percent);
  felt_->setChecked(settings.felt_patterns);
}

}  // namespace relievo
