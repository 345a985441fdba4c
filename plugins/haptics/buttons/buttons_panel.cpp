// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/haptics/buttons/buttons_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QSignalBlocker>

namespace relievo {

ButtonsPanel::ButtonsPanel(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("buttonsPanel"));
  setProperty("foldedAtFirst", true);  // As the window knows it: for those who want it.
  one_button_ = new QCheckBox(tr("Sca&nning with one button"));
  one_button_->setObjectName(QStringLiteral("oneButton"));
  one_button_->setAccessibleName(tr("Scanning with one button"));
  one_button_->setToolTip(
      tr("Any button: the first press begins to offer where am I, finer, coarser, move, forces; "
         "the next one takes what was offered last."));
  scan_ = new QDoubleSpinBox;
  scan_->setObjectName(QStringLiteral("scanTime"));
  scan_->setAccessibleName(tr("How long each command is offered, in seconds"));
  scan_->setToolTip(tr("How long each command is offered."));
  scan_->setRange(kLeastScanS, kMostScanS);
  scan_->setSingleStep(0.5);
  scan_->setDecimals(1);
  scan_->setSuffix(tr(" s"));
  space_mouse_ = new QComboBox;
  space_mouse_->setObjectName(QStringLiteral("spaceMouse"));
  space_mouse_->setAccessibleName(tr("What a SpaceMouse moves"));
  space_mouse_->setToolTip(tr(
      "What the cap of a 3Dconnexion SpaceMouse moves. The hand follows pushes only. In the view "
      "the relief follows the cap: pushed to a side, up or down it moves, toward you it comes "
      "nearer; tilted forward or back, or twisted, it turns."));
  space_mouse_->addItems({tr("The hand"), tr("The view")});
  rumble_ = new QCheckBox(tr("Gamepads r&umble (a cue)"));
  rumble_->setObjectName(QStringLiteral("rumble"));
  rumble_->setAccessibleName(tr("Gamepads rumble at contact and edge"));
  rumble_->setToolTip(tr(
      "A knock when the hand meets the surface, and a soft hum at the edge of the window. It is a "
      "cue: it has no direction and is no force."));
  auto* form = new QFormLayout(this);
  form->setRowWrapPolicy(QFormLayout::WrapLongRows);
  form->addRow(one_button_);
  form->addRow(tr("Each offer"), scan_);
  form->addRow(tr("SpaceMouse moves"), space_mouse_);
  form->addRow(rumble_);
  setSettings({});
  connect(one_button_, &QCheckBox::toggled, this, &ButtonsPanel::changed);
  connect(scan_, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this,
          &ButtonsPanel::changed);
  connect(space_mouse_, QOverload<int>::of(&QComboBox::currentIndexChanged), this,
          &ButtonsPanel::changed);
  connect(rumble_, &QCheckBox::toggled, this, &ButtonsPanel::changed);
}

void ButtonsPanel::changed() {
  scan_->setEnabled(one_button_->isChecked());
  Q_EMIT settingsChanged();
}

void ButtonsPanel::setSettings(const ButtonSettings& settings) {
  const QSignalBlocker a(one_button_), b(scan_), c(space_mouse_), d(rumble_);
  one_button_->setChecked(settings.one_button);
  scan_->setValue(settings.scan_s);
  scan_->setEnabled(settings.one_button);
  space_mouse_->setCurrentIndex(static_cast<int>(settings.space_mouse));
  rumble_->setChecked(settings.rumble);
}

ButtonSettings ButtonsPanel::settings() const {
  return {.one_button = one_button_->isChecked(),
          .scan_s = scan_->value(),
          .space_mouse = static_cast<SpaceMouseMoves>(space_mouse_->currentIndex()),
          .rumble = rumble_->isChecked()};
}

}  // namespace relievo
