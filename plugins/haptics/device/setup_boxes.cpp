// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/haptics/device/setup_boxes.h"

#include <QClipboard>
#include <QFile>
#include <QFormLayout>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QPlainTextEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

#include "core/base/failure.h"
#include "haptics/device/falcon/firmware.h"
#include "haptics/device/falcon/usb_bus.h"
#include "plugins/haptics/device/homing_picture.h"
#include "plugins/haptics/device/shown_place.h"
#include "plugins/haptics/panel/panel_widgets.h"
#include "plugins/haptics/shown_file.h"
#include "ui/message/message_text.h"

namespace relievo {

using falcon::LinkState;

QPlainTextEdit* textPage(const char* object_name, const QString& accessible, int lines) {
  auto* edit = named(new QPlainTextEdit, object_name, accessible);
  edit->setReadOnly(true);
  edit->setTabChangesFocus(true);  // The keyboard is never caught in it.
  edit->setMinimumHeight(lines * edit->fontMetrics().lineSpacing() + 12);
  return edit;
}

SetupStartBox::SetupStartBox() : QGroupBox(tr("Start")) {
  auto* column = new QVBoxLayout(this);
  auto* row = new QHBoxLayout;
  retry_ = named(new QPushButton(tr("&Retry")), "setupRetry", tr("Retry"));
  auto* browse =
      named(new QPushButton(tr("&Firmware file…")), "setupFirmware", tr("Firmware file"));
  copy_rule_ = named(new QPushButton(tr("&Copy rule")), "setupCopyRule", tr("Copy rule"));
  for (QPushButton* button : {retry_, browse, copy_rule_}) row->addWidget(button);
  row->addStretch(1);
  column->addLayout(row);
  firmware_ = named(new QLabel, "setupFirmwareFile", tr("Firmware file in use"));
  firmware_->setWordWrap(true);
  firmware_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  column->addWidget(firmware_);
  upload_ = named(new QProgressBar, "setupUpload", tr("Firmware loaded"));
  upload_->setRange(0, 1);
  upload_->setValue(0);
  upload_->setFormat(tr("not loaded yet"));
  column->addWidget(upload_);
  rule_ = textPage("setupRule", tr("Rule that gives access"), 6);
  rule_->setPlainText(tr("# As an administrator, write this into "
                         "/etc/udev/rules.d/60-relievo-falcon.rules, then replug:\n") +
                      QString::fromStdString(falcon::udevRule()));
  rule_->hide();
  column->addWidget(rule_);
  connect(retry_, &QPushButton::clicked, this, &SetupStartBox::retryAsked);
  connect(browse, &QPushButton::clicked, this, &SetupStartBox::browseAsked);
  connect(copy_rule_, &QPushButton::clicked, this, [this] {
    QGuiApplication::clipboard()->setText(QString::fromStdString(falcon::udevRule()));
    Q_EMIT ruleCopied();
  });
}

void SetupStartBox::showStatus(const falcon::LinkStatus& status) {
  const bool forbidden = status.state == LinkState::forbidden;
  rule_->setVisible(forbidden);
  copy_rule_->setEnabled(forbidden);
  retry_->setEnabled(status.state == LinkState::no_firmware ||
                     status.state == LinkState::not_started);
  if (status.firmware_bytes > 0) {
    upload_->setRange(0, static_cast<int>(status.firmware_bytes));
    upload_->setValue(static_cast<int>(status.uploaded_bytes));
    upload_->setFormat(tr("attempt %1 of %2, %p %").arg(status.attempt).arg(status.attempts));
  } else if (status.firmware_was_running) {
    upload_->setRange(0, 1);
    upload_->setValue(1);
    upload_->setFormat(tr("was running already"));
  }
}

void SetupStartBox::showFirmware(const std::string& chosen) {
  QString text;
  try {
    const falcon::Firmware found = falcon::findFirmware(falcon::firmwarePlaces(chosen));
    const QString name = shownFilePath(QFile::decodeName(found.file.c_str()));
    text = found.known_as ? tr("Firmware: %1, %2").arg(name, messageText(*found.known_as))
                          : tr("Firmware: %1, accepted by you").arg(name);
  } catch (const Error&) {
    // Why, the state says once it is needed: one that runs already needs no file.
    text = chosen.empty() ? tr("Firmware: no file found yet")
                          : tr("Firmware: %1 cannot be used")
                                .arg(shownFilePath(QFile::decodeName(chosen.c_str())));
  }
  setTextIfNew(firmware_, text);
}

QString SetupStartBox::firmwareText() const {
  return firmware_->text();
}

SetupHomingBox::SetupHomingBox() : QGroupBox(tr("Homing")) {
  auto* row = new QHBoxLayout(this);
  picture_ = new HomingPicture;
  row->addWidget(picture_, 0, Qt::AlignTop);
  auto* form = new QFormLayout;
  row->addLayout(form, 1);
  const std::array<QString, falcon::kArms> names{tr("Top arm"), tr("Right arm"), tr("Left arm")};
  constexpr std::array<const char*, falcon::kArms> kNames{"armTop", "armRight", "armLeft"};
  for (std::size_t i = 0; i < falcon::kArms; ++i) {
    arms_[i] = named(new QLabel, kNames[i], names[i]);
    form->addRow(names[i], arms_[i]);
  }
  hand_ = named(new QLabel, "setupHand", tr("Place of the hand"));
  hand_->setWordWrap(true);
  // Nothing jumps when it is known.
  hand_->setMinimumHeight(2 * hand_->fontMetrics().lineSpacing());
  form->addRow(tr("Hand"), hand_);
}

void SetupHomingBox::showStatus(const falcon::LinkStatus& status) {
  for (std::size_t i = 0; i < falcon::kArms; ++i) {
    const bool homed = (status.homed >> i & 1U) != 0;
    setTextIfNew(arms_[i], homed ? tr("✓ found") : tr("– missing"));
  }
  if (picture_->state() != status.state) picture_->show(status.state);
  const bool ready = status.state == LinkState::ready;
  setTextIfNew(hand_, ready ? tr("%1 right, %2 up, %3 out, in millimetres; %4 answers per second")
                                  .arg(withoutMinusZero(status.position.x), 0, 'f', 1)
                                  .arg(withoutMinusZero(status.position.y), 0, 'f', 1)
                                  .arg(withoutMinusZero(status.position.z), 0, 'f', 1)
                                  .arg(status.rate_hz, 0, 'f', 0)
                            : tr("not known before homing"));
}

}  // namespace relievo
