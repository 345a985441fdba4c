// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <future>
#include <memory>
#include <QObject>
#include <QString>
#include <QTimer>
#include <stop_token>
#include <string>
#include <vector>

#include "haptics/device/device.h"

namespace relievo {

namespace foreign {
class ForeignDevice;
}

/// A device that a trusted plug-in for devices or Haply's service has told of.
struct PluginDevice {
  QString id, name;  ///< As makeDevice() takes it; for people.
};

/// Asks the plug-ins for devices which devices they find, each in a process of its own, and Haply's
/// service which it sees; beside the window. Without such a plug-in nothing is started, and without
/// the service nobody is spoken to. All calls: GUI thread.
class PluginDevices : public QObject {
  Q_OBJECT
 public:
  PluginDevices();
  ~PluginDevices() override;  ///< Gives up, and joins.

  void look();  ///< found() comes later; nothing new where it looks already.

 Q_SIGNALS:
  void found(const std::vector<relievo::PluginDevice>& devices);

 private:
  void take();

  QTimer timer_;
  std::stop_source stop_;
  std::future<std::vector<PluginDevice>> asking_;
};

/// Opens a device of a plug-in beside the window: it may take a minute. All calls: GUI thread.
class DeviceOpening {
 public:
  /// @throw DeviceError  there is no such device, or its plug-in may not run
  explicit DeviceOpening(const std::string& id);
  ~DeviceOpening();  ///< Gives up, and joins.
  DeviceOpening(const DeviceOpening&) = delete;
  DeviceOpening& operator=(const DeviceOpening&) = delete;

  const QString& name() const { return name_; }
  bool isDone() const;
  /// The open device, once it is done. @throw DeviceError, FileError  why it was not opened
  std::unique_ptr<Device> take();

 private:
  std::unique_ptr<Device> device_;
  foreign::ForeignDevice* foreign_ = nullptr;  // The same.
  QString name_;
  std::future<void> opening_;
};

/// Whether a device of that id is one of a plug-in.
bool isPluginDevice(const std::string& id);

}  // namespace relievo
