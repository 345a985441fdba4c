// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <QStringList>
#include <string>
#include <vector>

#include "haptics/space/grip_position.h"
#include "plugins/haptics/device/plugin_devices.h"

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;

namespace relievo {

/// How a grip position is called for people, one after another.
QStringList gripPositionTexts();

/// What the rows below choose.
struct DeviceChoice {
  std::string device;  ///< Its id.
  bool holds_grip = true;
  GripPosition grip = GripPosition::upright;
};

/// The rows of the panel Touch about the device in the hand: which one, how it stands, whether
/// anybody has tried such a device, how warm its motors are. [GUI thread]
class DeviceRows : public QObject {
  Q_OBJECT
 public:
  explicit DeviceRows(QObject* parent);
  void addTo(QFormLayout* form);

  /// Those that are there now, and those of plug-ins that were found; the chosen one stays chosen.
  void list();
  void setPluginDevices(std::vector<PluginDevice> devices);

  DeviceChoice choice() const;
  void set(const DeviceChoice& choice);  ///< Emits nothing.
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
  QComboBox* grip_;
  std::vector<PluginDevice> plugin_devices_;
  bool turned_to_ = false;  // Somebody has, once: Haply's service may be looked for.
};

}  // namespace relievo
