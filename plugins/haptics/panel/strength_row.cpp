// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/haptics/panel/strength_row.h"

#include <array>
#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <QStandardItemModel>

#include "haptics/loop/strength_preset.h"
#include "plugins/haptics/panel/panel_widgets.h"
#include "plugins/haptics/touch_settings.h"

namespace relievo {

namespace {
constexpr int kOwnValue = static_cast<int>(kStrengthPresets.size());  // Index after the presets.

/// Of a strength that is between them: kOwnValue.
int presetOf(int percent) {
  int index = 0;
  while (index < kOwnValue &&
         kStrengthPresets.at(static_cast<std::size_t>(index)).percent != percent) {
    ++index;
  }
  return index;
}

QStringList presetTexts() {
  const std::array<QString, kStrengthPresets.size()> names{
      StrengthRow::tr("Gentle"), StrengthRow::tr("Medium"), StrengthRow::tr("Full")};
  QStringList texts;
  for (std::size_t i = 0; i < names.size(); ++i) {
    texts << StrengthRow::tr("%1, %2 %").arg(names.at(i)).arg(kStrengthPresets.at(i).percent);
  }
  return texts;
}
}  // namespace

QString strengthPresetText(int percent) {
  const int index = presetOf(percent);
  return index < kOwnValue ? presetTexts().at(index) : QString();
}

StrengthRow::StrengthRow(QObject* parent) : QObject(parent) {
  strength_ = named(new QSlider(Qt::Horizontal), "strengthSlider", tr("Strength in percent"));
  strength_->setRange(0, 100);
  strength_->setSingleStep(kStrengthStep);
  strength_->setPageStep(2 * kStrengthStep);
  strength_->setToolTip(tr("Multiplies every force. The limit stays."));
  value_ = named(new QLabel, "strengthValue", tr("Strength"));
  value_->setMinimumWidth(value_->fontMetrics().horizontalAdvance(QStringLiteral("100 %")));
  preset_ =
      choice("strengthPreset", tr("Strength of all forces"), presetTexts() << tr("Own strength"));
  preset_->setToolTip(tr("How strong all forces are, in one choice."));
  // Shown when no preset fits; nothing to choose.
  qobject_cast<QStandardItemModel*>(preset_->model())->item(kOwnValue)->setEnabled(false);
  show();
  connect(strength_, &QSlider::valueChanged, this, [this] {
    show();
    Q_EMIT changed();
  });
  connect(preset_, QOverload<int>::of(&QComboBox::currentIndexChanged), this,
          &StrengthRow::takePreset);
}

void StrengthRow::addTo(QFormLayout* form) {
  auto* row = new QHBoxLayout;
  row->addWidget(strength_, 1);
  row->addWidget(value_);
  auto* label = new QLabel(tr("St&rength"));
  label->setBuddy(strength_);
  form->addRow(label, row);
}

QComboBox* StrengthRow::presets() const {
  return preset_;
}

int StrengthRow::percent() const {
  return strength_->value();
}

void StrengthRow::set(int percent) {
  const QSignalBlocker blocker(strength_);
  strength_->setValue(percent);
  show();
}

void StrengthRow::takePreset(int index) {
  if (index < 0 || index >= kOwnValue) return;
  strength_->setValue(kStrengthPresets.at(static_cast<std::size_t>(index)).percent);
}

void StrengthRow::show() {
  value_->setText(tr("%1 %").arg(strength_->value()));
  const QSignalBlocker blocker(preset_);
  preset_->setCurrentIndex(presetOf(strength_->value()));
}

}  // namespace relievo
