// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/haptics/device/haply_steps.h"

#include <QFormLayout>
#include <QLabel>
#include <QStringList>

#include "core/message/catalogue.h"
#include "plugins/haptics/device/shown_place.h"
#include "plugins/haptics/panel/panel_widgets.h"

namespace relievo {

using haply::LinkState;

HaplySteps::HaplySteps() : QGroupBox(tr("Steps")) {
  auto* form = new QFormLayout(this);
  const std::array<QString, kSteps> titles{tr("Inverse Service runs"), tr("Device is plugged in"),
                                           tr("Motors have power"),    tr("Service has started it"),
                                           tr("Calibrated"),           tr("Set up for touching")};
  constexpr std::array<const char*, kSteps> kNames{"stepService", "stepDevice",     "stepPower",
                                                   "stepStarted", "stepCalibrated", "stepSetUp"};
  for (std::size_t i = 0; i < kSteps; ++i) {
    steps_[i] = readout(kNames[i], titles[i]);
    form->addRow(titles[i], steps_[i]);
  }
  hand_ = readout("setupHand", tr("Place of the hand"));
  // Nothing jumps when it is known.
  hand_->setMinimumHeight(2 * hand_->fontMetrics().lineSpacing());
  buttons_ = readout("setupButtons", tr("Buttons that are pressed"));
  form->addRow(tr("Hand"), hand_);
  form->addRow(tr("Buttons"), buttons_);
}

std::size_t HaplySteps::stepsDone(LinkState state) noexcept {
  switch (state) {
    case LinkState::closed:
    case LinkState::no_service:
    case LinkState::other_service:
    case LinkState::old_service:
      return 0;
    case LinkState::no_device:
    case LinkState::several:
      return 1;
    case LinkState::no_power:
      return 2;
    case LinkState::not_started:
      return 3;
    case LinkState::not_calibrated:
      return 4;
    case LinkState::checking:
    case LinkState::foreign:
    case LinkState::disobeyed:
    case LinkState::pushed:
    case LinkState::silent:
      return 5;
    case LinkState::ready:
      break;
  }
  return kSteps;
}

void HaplySteps::showStatus(const haply::LinkStatus& status) {
  const std::size_t done = stepsDone(status.state);
  // What its status told last is not known any more.
  const bool unknown = status.state == LinkState::silent || status.state == LinkState::checking;
  for (std::size_t i = 0; i < kSteps; ++i) {
    const bool of_device = i >= 2 && i + 1 < kSteps;
    const QString word = i < done && !(unknown && of_device) ? tr("✓ done")
                         : i == done                         ? tr("– waits for this")
                                                             : tr("– not known yet");
    setTextIfNew(steps_[i], word);
  }
  const bool is_seen = status.state >= LinkState::checking && status.state != LinkState::silent;
  setTextIfNew(hand_, is_seen ? tr("%1 right, %2 up, %3 out, in millimetres; %4 answers per second")
                                    .arg(withoutMinusZero(status.position.x), 0, 'f', 1)
                                    .arg(withoutMinusZero(status.position.y), 0, 'f', 1)
                                    .arg(withoutMinusZero(status.position.z), 0, 'f', 1)
                                    .arg(status.rate_hz, 0, 'f', 0)
                              : tr("not known before the device is there"));
  QStringList pressed;
  const std::array<QString, 4> names{tr("Plus"), tr("Forward"), tr("Centre"), tr("Minus")};
  for (std::size_t i = 0; i < names.size(); ++i) {
    if ((status.buttons >> i & 1U) != 0) pressed << names[i];
  }
  setTextIfNew(buttons_, pressed.isEmpty() ? tr("none") : pressed.join(QStringLiteral(", ")));
}

}  // namespace relievo
