// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/haptics/device/haply_setup_dialog.h"

#include <chrono>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <utility>

#include "core/base/failure.h"
#include "haptics/device/haply/service_address.h"
#include "haptics/rt/realtime_thread.h"
#include "plugins/haptics/device/falcon_status_announcer.h"
#include "plugins/haptics/panel/panel_widgets.h"
#include "ui/message/message_text.h"

namespace relievo {

using haply::LinkState;

namespace {
constexpr int kFrameMs = 16, kFramesPerReadout = 6, kFramesPerLook = 60;
}  // namespace

HaplySetupDialog::HaplySetupDialog(HaplyMaker make, std::string chosen,
                                   const haply::ServiceAddress& address, QWidget* parent)
    : SetUpDialog(parent),
      make_(std::move(make)),
      chosen_(std::move(chosen)),
      device_(make_(chosen_)),
      events_(address) {
  setObjectName(QStringLiteral("haplySetup"));
  setWindowTitle(tr("Device set-up: Haply"));
  build();
  connect(&timer_, &QTimer::timeout, this, &HaplySetupDialog::frame);
  timer_.start(kFrameMs);
}

HaplySetupDialog::~HaplySetupDialog() {
  timer_.stop();
  closeDevice();
}

void HaplySetupDialog::build() {
  auto* column = new QVBoxLayout(this);
  state_ = readout("setupState", tr("State of the Haply device"));
  constexpr int kWide = 520, kLines = 3;
  state_->setMinimumWidth(kWide);
  state_->setMinimumHeight(kLines * state_->fontMetrics().lineSpacing());
  state_->setText(tr("Haply's Inverse Service is being looked for."));
  column->addWidget(state_);
  event_ = readout("setupEvent", tr("What the service told last"));
  event_->setMinimumHeight(event_->fontMetrics().lineSpacing());
  column->addWidget(event_);
  steps_ = new HaplySteps;
  column->addWidget(steps_);
  auto* row = new QHBoxLayout;
  devices_ = named(new QComboBox, "setupDevices", tr("Which Haply device"));
  auto* label = new QLabel(tr("&Device"));
  label->setBuddy(devices_);
  retry_ = named(new QPushButton(tr("&Try again")), "setupRetry", tr("Try again"));
  retry_->setToolTip(
      tr("After another program set the device up, or the service did not obey forces"));
  row->addWidget(label);
  row->addWidget(devices_, 1);
  row->addWidget(retry_);
  column->addLayout(row);
  column->addStretch(1);
  auto* buttons = new QDialogButtonBox;
  save_ = buttons->addButton(tr("&Use this device"), QDialogButtonBox::AcceptRole);
  named(save_, "setupSave", tr("Use this device"));
  auto* other = buttons->addButton(tr("Set up a &Falcon…"), QDialogButtonBox::ActionRole);
  named(other, "setupOther", tr("Set up a Falcon"));
  named(buttons->addButton(QDialogButtonBox::Close), "setupClose", tr("Close"));
  column->addWidget(buttons);
  connect(devices_, QOverload<int>::of(&QComboBox::activated), this, &HaplySetupDialog::choose);
  connect(retry_, &QPushButton::clicked, this, [this] { device_->retry(); });
  connect(other, &QPushButton::clicked, this, &HaplySetupDialog::otherAsked);
  connect(buttons, &QDialogButtonBox::accepted, this, &HaplySetupDialog::save);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  steps_->showStatus({});
  retry_->setEnabled(false);
  save_->setEnabled(false);
}

std::string HaplySetupDialog::deviceId() const {
  return device_->info().id;
}

void HaplySetupDialog::say(const QString& text) {
  if (text.isEmpty() || std::exchange(said_, text) == text) return;
  Q_EMIT said(text);
}

void HaplySetupDialog::frame() {
  // Its link rests where nobody asks; nothing here pushes.
  if (open_) device_->exchange({}, monotonicNs());
  ++frames_;
  lookForIt();
  if (frames_ % kFramesPerReadout != 0) return;
  showStatus();
  showEvents();
}

void HaplySetupDialog::showEvents() {
  const std::int64_t now_ns = monotonicNs();
  for (const haply::ServiceEvent& event : events_.poll(now_ns)) {
    if (!event_news_.isNews(event, now_ns)) continue;
    const Message message = haply::describe(event);
    setTextIfNew(event_, screenText(message));
    say(spokenMessage(message));
  }
}

/// Until it is open; then its link finds it again by itself.
void HaplySetupDialog::lookForIt() {
  if (open_) return;
  if (!opening_.valid()) {
    if (frames_ < next_look_) return;
    opening_ = std::async(std::launch::async, [device = device_.get()] { device->open(); });
    return;
  }
  if (opening_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return;
  next_look_ = frames_ + kFramesPerLook;
  try {
    opening_.get();
    open_ = true;
  } catch (const Error& error) {
    // Its status says why, but for a build that cannot speak with the service at all.
    if (device_->status().state == LinkState::closed) {
      const Message message = messageOf(error);
      setTextIfNew(state_, screenText(message));
      say(spokenMessage(message));
    }
  }
  showStatus();
}

void HaplySetupDialog::showStatus() {
  const haply::LinkStatus& status = device_->status();
  if (!open_ && status.state == LinkState::closed) return;  // Nothing is known yet.
  const Message message = haply::describe(status);
  setTextIfNew(state_, screenText(message));
  steps_->showStatus(status);
  showDevices(status);
  // All else heals by itself.
  retry_->setEnabled(status.state == LinkState::disobeyed || status.state == LinkState::foreign);
  save_->setEnabled(status.state == LinkState::ready);
  // It is asked again and again whether it is set up: that is no news.
  if (status.state != LinkState::checking) say(spokenMessage(message));
}

/// Where several could be meant, or another one than was chosen.
void HaplySetupDialog::showDevices(const haply::LinkStatus& status) {
  const QStringList others =
      QString::fromUtf8(status.others.data()).split(QStringLiteral(", "), Qt::SkipEmptyParts);
  const QString own = QString::fromUtf8(status.id.text());
  const QStringList ids = others.isEmpty() && !own.isEmpty() ? QStringList{own} : others;
  QStringList shown;
  for (int i = 0; i < devices_->count(); ++i) shown << devices_->itemText(i);
  if (ids == shown || (ids.isEmpty() && !open_ && devices_->count() == 0)) return;
  const QSignalBlocker blocker(devices_);
  devices_->clear();
  devices_->addItems(ids);
  devices_->setCurrentIndex(static_cast<int>(ids.indexOf(QString::fromStdString(chosen_))));
  if (ids.size() == 1 && !own.isEmpty()) devices_->setCurrentIndex(0);
}

void HaplySetupDialog::choose() {
  const std::string id = devices_->currentText().toStdString();
  if (id.empty() || (open_ && id == device_->status().id.view())) return;
  closeDevice();
  chosen_ = id;
  device_ = make_(chosen_);
  open_ = false;
  next_look_ = 0;
}

void HaplySetupDialog::closeDevice() {
  if (opening_.valid()) {
    device_->giveUp();
    opening_.wait();
    opening_ = {};
  }
  device_->close();
}

void HaplySetupDialog::save() {
  timer_.stop();
  closeDevice();  // Whoever uses it next begins a session of its own.
  Q_EMIT saved();
  accept();
}

HaplySetupDialog* makeHaplySetup(const std::string& chosen, QWidget* parent) {
  // A name that is none is said before anything opens.
  const haply::ServiceAddress address = haply::serviceAddress();
  auto* dialog = new HaplySetupDialog(
      [](const std::string& one) {
        return std::make_unique<haply::HaplyDevice>(haply::inverseService(haply::serviceAddress()),
                                                    one);
      },
      chosen, address, parent);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  return dialog;
}

}  // namespace relievo
