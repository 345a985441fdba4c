// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <future>
#include <memory>
#include <QTimer>
#include <string>

#include "haptics/device/haply/event_channel.h"
#include "haptics/device/haply/haply_device.h"
#include "plugins/haptics/device/haply_steps.h"
#include "plugins/haptics/device/set_up_dialog.h"

class QComboBox;
class QLabel;
class QPushButton;

namespace relievo {

/// Which device of Haply's service, closed; empty: the only one. @throw Error  of the environment
using HaplyMaker = std::function<std::unique_ptr<haply::HaplyDevice>(const std::string& chosen)>;

/// From the service to touch: what keeps an Inverse3 or Minverse from being felt, and what to do,
/// step by step. Nothing pushes. All of it by keyboard, every change said. [GUI thread]
class HaplySetupDialog : public SetUpDialog {
  Q_OBJECT
 public:
  /// @param address  where the service's events are listened to
  HaplySetupDialog(HaplyMaker make, std::string chosen, const haply::ServiceAddress& address,
                   QWidget* parent = nullptr);
  ~HaplySetupDialog() override;

  const haply::LinkStatus& status() { return device_->status(); }
  std::string deviceId() const override;

 private:
  void build();
  void frame();
  void lookForIt();
  void showStatus();
  void showDevices(const haply::LinkStatus& status);
  void choose();
  void closeDevice();
  void save();
  void say(const QString& text);
  void showEvents();

  HaplyMaker make_;
  std::string chosen_;
  std::unique_ptr<haply::HaplyDevice> device_;
  haply::EventChannel events_;
  haply::EventNews event_news_;
  std::future<void> opening_;  // Valid: it is being looked for, beside the window.
  bool open_ = false;
  int frames_ = 0, next_look_ = 0;
  QTimer timer_;
  QString said_;

  QLabel *state_ = nullptr, *event_ = nullptr;
  HaplySteps* steps_ = nullptr;
  QComboBox* devices_ = nullptr;
  QPushButton *retry_ = nullptr, *save_ = nullptr;
};

/// By the service of this computer, or as the environment says.
/// @throw Error  the environment names no place
HaplySetupDialog* makeHaplySetup(const std::string& chosen, QWidget* parent);

}  // namespace relievo
