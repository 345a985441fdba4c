// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <string>
#include <vector>

#include "plugins/haptics/device/plugin_devices.h"

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;

namespace relievo {

/// The rows of the panel Touch about the device in the hand: which one, whether anybody has tried
/// such a device, how warm its motors are. [GUI thread]
class DeviceRows : public QObject {
  Q_OBJECT
 public:
  explicit DeviceRows(QObject* parent);
  void addTo(QFormLayout* form);

  /// Those that are there now, and those of plug-ins that were found; the chosen one stays chosen.
  void list();
  void setPluginDevices(std::vector<PluginDevice> devices);

  std::string device() const;  ///< Id of the chosen one.
  bool holdsGrip() const;
  void set(const std::string& device, bool holds_grip);  ///< Emits nothing.
  /// @param heat  a sentence; empty: no device says it
  void showHeat(const QString& heat);

 Q_SIGNALS:
  void changed();  ///< By the person.
  void wanted();   ///< Somebody turns to the list of devices.

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void choose(const QString& id);
  void add(const QString& name, const QString& id);
  void tellApart();
  void showTried();
  void takeChange();

  QComboBox* device_;
  QLabel* tried_;  // Hidden where nobody can feel a force.
  QLabel* heat_;   // Hidden where no device says it.
  QCheckBox* holds_grip_;
  std::vector<PluginDevice> plugin_devices_;
};

}  // namespace relievo
