// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <QTimer>

#include "haptics/device/falcon/calibration.h"
#include "haptics/device/falcon/falcon_device.h"
#include "haptics/device/falcon/self_test.h"
#include "plugins/haptics/device/falcon_status_announcer.h"
#include "plugins/haptics/device/set_up_dialog.h"

class QCheckBox;
class QDoubleSpinBox;
class QLabel;
class QPlainTextEdit;
class QPushButton;
class QScrollArea;

namespace relievo {

class SetupHomingBox;
class SetupStartBox;

/// From plug to touch, step by step: find, permission, firmware, homing, self test, calibration,
/// handedness. All of it by keyboard, every change said. Holds the Falcon while it is open.
/// [GUI thread]
class DeviceSetupDialog : public SetUpDialog {
  Q_OBJECT
 public:
  /// @param device  the Falcon, closed; it is opened as soon as one is plugged in
  DeviceSetupDialog(std::unique_ptr<falcon::FalconDevice> device, falcon::FalconSettings settings,
                    QWidget* parent = nullptr);
  ~DeviceSetupDialog() override;

  /// Checks the file and copies it to the user's folder; then the Falcon is started.
  /// @return false: refused, and said why
  bool installFirmware(const QString& file, bool accept_unknown);
  const falcon::LinkStatus& status() { return device_->status(); }
  /// Of the Falcon that was set up.
  std::string deviceId() const override { return device_->info().id; }
  /// The computer is about to sleep: test and calibration end at zero force, the old setting stays.
  void endBeforeSleep() override;

 private:
  void build();
  SetupStartBox* buildStart();
  QWidget* buildTests();
  void frame();
  void showStatus();
  void step();
  void startSelfTest();
  void calibrate();
  void showTest();
  void browse();
  void save();
  void say(const QString& text);
  void showEndOfResults();

  std::unique_ptr<falcon::FalconDevice> device_;
  falcon::FalconSettings settings_;
  std::optional<falcon::SelfTest> test_;
  std::optional<falcon::Calibration> calibration_;
  QTimer timer_;
  QString last_said_, notice_;
  FalconStatusAnnouncer news_;
  int frames_ = 0;

  QLabel* state_ = nullptr;
  SetupStartBox* start_ = nullptr;
  SetupHomingBox* homing_ = nullptr;
  QPushButton* self_test_ = nullptr;
  QPlainTextEdit* results_ = nullptr;
  QScrollArea* parts_ = nullptr;
  QDoubleSpinBox* weight_ = nullptr;
  QPushButton* calibrate_ = nullptr;
  QLabel* gain_ = nullptr;
  QCheckBox* left_handed_ = nullptr;
  QPushButton *save_ = nullptr, *close_ = nullptr;
};

/// On the Falcon that is or will be plugged in, with the settings of this user.
/// @param choice  which, if there are several
DeviceSetupDialog* makeDeviceSetup(const falcon::FalconChoice& choice, QWidget* parent);

}  // namespace relievo
