// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/haptics/device/device_setup_dialog.h"

#include <array>
#include <QApplication>
#include <QCheckBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QFileDialog>
#include <QGroupBox>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScreen>
#include <QScrollArea>
#include <QScrollBar>
#include <QVBoxLayout>
#include <utility>

#include "core/base/failure.h"
#include "haptics/device/falcon/firmware.h"
#include "haptics/device/falcon/settings_file.h"
#include "haptics/device/falcon/usb_bus.h"
#include "haptics/rt/realtime_thread.h"
#include "plugins/haptics/device/setup_boxes.h"
#include "plugins/haptics/panel/panel_widgets.h"
#include "ui/message/message_text.h"

namespace relievo {

using falcon::LinkState;

namespace {

constexpr std::array<const char*, 3> kResults{
    QT_TRANSLATE_NOOP("relievo::DeviceSetupDialog", "passed"),
    QT_TRANSLATE_NOOP("relievo::DeviceSetupDialog", "failed"),
    QT_TRANSLATE_NOOP("relievo::DeviceSetupDialog", "not seen")};
}  // namespace

DeviceSetupDialog::DeviceSetupDialog(std::unique_ptr<falcon::FalconDevice> device,
                                     falcon::FalconSettings settings, QWidget* parent)
    : SetUpDialog(parent), device_(std::move(device)), settings_(std::move(settings)) {
  setObjectName(QStringLiteral("deviceSetup"));
  setWindowTitle(tr("Device set-up"));
  build();
  // Whole where there is room; Qt would take two thirds of the screen at most, and 24 lines of what
  // scrolls.
  constexpr double kOfScreen = 0.9;
  const QSize left_out = parts_->widget()->sizeHint() - parts_->sizeHint();
  const QSize bar(parts_->verticalScrollBar()->sizeHint().width(), 0);
  resize((sizeHint() + left_out.expandedTo({0, 0}) + bar)
             .boundedTo(kOfScreen * QGuiApplication::primaryScreen()->availableSize()));
  device_->openWhenPlugged();
  connect(&timer_, &QTimer::timeout, this, &DeviceSetupDialog::frame);
  // Tests play the loop's part from here. A frame that comes late costs force, never adds it: the
  // driver takes an order older than 20 ms for zero.
  constexpr int kStepMs = 2;
  timer_.setTimerType(Qt::PreciseTimer);
  timer_.start(kStepMs);
  // Not here: nobody could hear yet what it says.
  QTimer::singleShot(0, this, &DeviceSetupDialog::showStatus);
}

DeviceSetupDialog::~DeviceSetupDialog() {
  timer_.stop();
  device_->close();
}

void DeviceSetupDialog::build() {
  auto* column = new QVBoxLayout(this);
  state_ = named(new QLabel, "setupState", tr("State of the Falcon"));
  state_->setWordWrap(true);
  state_->setMinimumWidth(520);
  state_->setMinimumHeight(3 * state_->fontMetrics().lineSpacing());
  state_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  column->addWidget(state_);
  // What it does and how to leave stay in sight when large text leaves no room for the rest.
  auto* rest = new QWidget;
  auto* parts = new QVBoxLayout(rest);
  parts->setContentsMargins(0, 0, 0, 0);
  start_ = buildStart();
  homing_ = new SetupHomingBox;
  parts->addWidget(start_);
  parts->addWidget(homing_);
  parts->addWidget(buildTests(), 1);
  left_handed_ = named(new QCheckBox(tr("&Left-handed: plus and minus change sides")), "leftHanded",
                       tr("Left-handed"));
  left_handed_->setChecked(settings_.left_handed);
  parts->addWidget(left_handed_);
  // Not among the buttons below, which large text would make wider than a small screen.
  auto* other = named(new QPushButton(tr("Set up a &Haply device…")), "setupOther",
                      tr("Set up a Haply device"));
  connect(other, &QPushButton::clicked, this, &DeviceSetupDialog::otherAsked);
  parts->addWidget(other, 0, Qt::AlignLeft);
  auto* scroll = parts_ = named(new QScrollArea, "setupParts", tr("Device set-up"));
  scroll->setWidget(rest);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setSizeAdjustPolicy(QAbstractScrollArea::AdjustToContents);
  scroll->setFocusPolicy(Qt::NoFocus);
  // Qt does it only for steps within the area.
  connect(qApp, &QApplication::focusChanged, scroll, [scroll, rest](QWidget*, QWidget* now) {
    if (now != nullptr && rest->isAncestorOf(now)) scroll->ensureWidgetVisible(now);
  });
  // A line above that becomes longer moves what is asked for out of sight. Queued, because the
  // range changes before what lies in it has its new place.
  connect(
      scroll->verticalScrollBar(), &QScrollBar::rangeChanged, this,
      [this] {
        if (test_ || calibration_) showEndOfResults();
      },
      Qt::QueuedConnection);
  column->addWidget(scroll, 1);
  auto* buttons = new QDialogButtonBox;
  save_ = buttons->addButton(tr("&Save and use the Falcon"), QDialogButtonBox::AcceptRole);
  named(save_, "setupSave", tr("Save and use the Falcon"));
  close_ = named(buttons->addButton(QDialogButtonBox::Close), "setupClose", tr("Close"));
  connect(buttons, &QDialogButtonBox::accepted, this, &DeviceSetupDialog::save);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  column->addWidget(buttons);
}

SetupStartBox* DeviceSetupDialog::buildStart() {
  auto* start = new SetupStartBox;
  start->showFirmware(settings_.firmware);
  connect(start, &SetupStartBox::retryAsked, this, [this] { device_->retry(); });
  connect(start, &SetupStartBox::browseAsked, this, &DeviceSetupDialog::browse);
  connect(start, &SetupStartBox::ruleCopied, this, [this] { say(tr("The rule is copied.")); });
  return start;
}

QWidget* DeviceSetupDialog::buildTests() {
  auto* group = new QGroupBox(tr("Test and calibration"));
  auto* column = new QVBoxLayout(group);
  auto* row = new QHBoxLayout;
  self_test_ = named(new QPushButton(tr("Self &test")), "setupSelfTest", tr("Self test"));
  weight_ = named(new QDoubleSpinBox, "setupWeight", tr("Weight for calibration in grams"));
  weight_->setRange(20, 300);
  weight_->setDecimals(1);
  weight_->setValue(100);
  weight_->setSuffix(tr(" g"));
  // Large text needs more than Qt leaves beside the arrows.
  weight_->setMinimumWidth(weight_->sizeHint().width() + weight_->fontMetrics().averageCharWidth());
  auto* label = new QLabel(tr("&Weight"));
  label->setBuddy(weight_);
  calibrate_ = named(new QPushButton(tr("C&alibrate")), "setupCalibrate", tr("Calibrate"));
  gain_ = named(new QLabel, "setupGain", tr("Force gain"));
  column->addWidget(self_test_, 0, Qt::AlignLeft);
  row->addWidget(label);
  row->addWidget(weight_);
  row->addWidget(calibrate_);
  row->addStretch(1);
  column->addLayout(row);
  column->addWidget(gain_);
  results_ = textPage("setupResults", tr("Results"), 8);
  column->addWidget(results_);
  connect(self_test_, &QPushButton::clicked, this, &DeviceSetupDialog::startSelfTest);
  connect(calibrate_, &QPushButton::clicked, this, &DeviceSetupDialog::calibrate);
  return group;
}

void DeviceSetupDialog::say(const QString& text) {
  if (text.isEmpty() || text == last_said_) return;
  last_said_ = text;
  Q_EMIT said(text);
}

void DeviceSetupDialog::frame() {
  step();
  constexpr int kStepsPerReadout = 8;
  if (++frames_ % kStepsPerReadout == 0) showStatus();
}

void DeviceSetupDialog::step() {
  const std::int64_t now = monotonicNs();
  if (test_ && test_->phase() != falcon::SelfTest::Phase::done) {
    test_->step(now);
  } else if (calibration_ && calibration_->phase() < falcon::Calibration::Phase::done) {
    calibration_->step(now);
    if (const auto gain = calibration_->result()) {
      settings_.counts_per_n_mm = *gain;
      settings_.grip_weight_n = calibration_->gripWeightN();
      device_->setGain(*gain);
    }
  } else {
    device_->exchange({}, now);
  }
}

void DeviceSetupDialog::showStatus() {
  const falcon::LinkStatus& status = device_->status();
  setTextIfNew(state_, screenText(falcon::describe(status)));
  start_->showStatus(status);
  homing_->showStatus(status);
  const bool ready = status.state == LinkState::ready;
  setTextIfNew(gain_, tr("%1 counts per N mm").arg(settings_.counts_per_n_mm, 0, 'f', 2));
  const bool testing = test_ && test_->phase() != falcon::SelfTest::Phase::done;
  const bool calibrating = calibration_ && calibration_->phase() < falcon::Calibration::Phase::done;
  self_test_->setEnabled(ready && !testing && !calibrating);
  const bool waits =
      calibrating && calibration_->phase() == falcon::Calibration::Phase::hang_weight;
  calibrate_->setEnabled(ready && !testing && (!calibrating || waits));
  calibrate_->setText(waits ? tr("Contin&ue") : tr("C&alibrate"));
  weight_->setEnabled(!calibrating);
  save_->setEnabled(ready && !testing && !calibrating);
  showTest();  // After the focus has left a button, which scrolls.
  const bool under_way = status.state == LinkState::starting || status.state == LinkState::homing ||
                         status.state == LinkState::pull_out;
  const QString leave = under_way ? tr("Cancel") : tr("Close");
  if (close_->text() != leave) {
    close_->setText(leave);
    close_->setAccessibleName(leave);
  }
  if (testing || calibrating) return;
  for (const QString& words : news_.take(status)) say(words);
}

void DeviceSetupDialog::showTest() {
  QString text = notice_;
  if (test_) {
    const QString prompt = messageText(test_->prompt());
    say(prompt);
    for (const falcon::SelfTestLine& line : test_->lines()) {
      text += tr(kResults[static_cast<std::size_t>(line.result)]) + QStringLiteral(": ") +
              messageText(line.text) + QLatin1Char('\n');
    }
    text += prompt;
  }
  if (calibration_) {
    text = messageText(calibration_->prompt());
    say(text);
  }
  if (results_->toPlainText() == text) return;
  results_->setPlainText(text);
  results_->moveCursor(QTextCursor::End);  // What is asked for now stands last.
  showEndOfResults();
}

void DeviceSetupDialog::showEndOfResults() {
  const QPoint end = results_->mapTo(parts_->widget(), QPoint(0, results_->height()));
  parts_->ensureVisible(end.x(), end.y(), 0, 0);
}

void DeviceSetupDialog::endBeforeSleep() {
  if (!test_ && !calibration_) return;
  test_.reset();
  calibration_.reset();
  device_->exchange({}, monotonicNs());
  notice_ =
      tr("The computer goes to sleep; the forces are off and this has ended. Begin again "
         "when it is awake.");
  say(notice_);
  showTest();
}

void DeviceSetupDialog::startSelfTest() {
  constexpr double kWaitForPersonSeconds = 40;  // All sides and all buttons.
  notice_.clear();
  calibration_.reset();
  test_.emplace(*device_, falcon::SelfTestOptions{.nudges = true,
                                                  .wait_for_person_s = kWaitForPersonSeconds});
}

void DeviceSetupDialog::calibrate() {
  if (calibration_ && calibration_->phase() == falcon::Calibration::Phase::hang_weight) {
    calibration_->weightHangs();
    return;
  }
  test_.reset();
  calibration_.emplace(*device_, settings_.counts_per_n_mm, weight_->value());
}

void DeviceSetupDialog::browse() {
  const QString file = QFileDialog::getOpenFileName(this, tr("Falcon firmware"), QString(),
                                                    tr("Firmware (*.bin);;All files (*)"));
  if (!file.isEmpty()) installFirmware(file, false);
}

bool DeviceSetupDialog::installFirmware(const QString& file, bool accept_unknown) {
  try {
    const falcon::Firmware firmware = falcon::readFirmware(QFile::encodeName(file).toStdString());
    const falcon::FirmwarePlaces places = falcon::firmwarePlaces();
    if (!accept_unknown && !falcon::isAccepted(firmware, places)) {
      const auto answer = QMessageBox::question(this, tr("Unknown firmware"),
                                                tr("The file has the form of a boot image, but "
                                                   "nobody knows this one (sha256 %1). Load it "
                                                   "into the Falcon all the same?")
                                                    .arg(QString::fromStdString(firmware.sha256)));
      if (answer != QMessageBox::Yes) return false;
    }
    settings_.firmware = falcon::installFirmware(firmware, places).string();
    falcon::FalconSettings stored = falcon::readSettings(falcon::settingsFile());
    stored.firmware = settings_.firmware;  // The rest is kept by Save.
    falcon::writeSettings(stored, falcon::settingsFile());
    start_->showFirmware(settings_.firmware);
  } catch (const Error& error) {
    notice_ = messageText(messageOf(error));
    say(notice_);
    return false;
  }
  notice_ = start_->firmwareText();
  say(notice_);
  device_->retry();
  return true;
}

void DeviceSetupDialog::save() {
  settings_.left_handed = left_handed_->isChecked();
  // Stored when it is installed; the preferences may have changed it since.
  settings_.firmware = falcon::readSettings(falcon::settingsFile()).firmware;
  try {
    falcon::writeSettings(settings_, falcon::settingsFile(), device_->status().serial.data());
  } catch (const Error& error) {
    say(messageText(messageOf(error)));
  }
  // Whoever uses it next must find it free.
  timer_.stop();
  device_->close();
  Q_EMIT saved();
  accept();
}

DeviceSetupDialog* makeDeviceSetup(const falcon::FalconChoice& choice, QWidget* parent) {
  const falcon::FalconChoice meant = falcon::settled(choice);
  const falcon::FalconSettings settings =
      falcon::readSettings(falcon::settingsFile(), meant.serial);
  auto* dialog = new DeviceSetupDialog(
      std::make_unique<falcon::FalconDevice>(std::make_unique<falcon::UsbBus>(meant),
                                             falcon::storedFirmwareSource(), settings),
      settings, parent);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  return dialog;
}

}  // namespace relievo
