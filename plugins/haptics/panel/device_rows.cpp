// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/haptics/panel/device_rows.h"

#include <QCheckBox>
#include <QComboBox>
#include <QEvent>
#include <QFormLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <utility>

#include "core/base/error.h"
#include "haptics/device_catalog.h"
#include "plugins/haptics/panel/panel_widgets.h"

namespace relievo {

DeviceRows::DeviceRows(QObject* parent) : QObject(parent) {
  device_ = choice("deviceList", tr("Device"), {});
  device_->setToolTip(
      tr("What the hand holds. A virtual hand is moved by the mouse and pushed by "
         "the force, as a real one is."));
  device_->installEventFilter(this);
  tried_ = readout("triedOnHardware", tr("Whether somebody has tried such a device"));
  heat_ = readout("motorHeat", tr("How warm the motors are"));
  heat_->hide();
  holds_grip_ = named(new QCheckBox(tr("Hold the grip's weig&ht")), "holdsGrip",
                      tr("Hold the grip's weight"));
  holds_grip_->setToolTip(tr(
      "While forces are on, the device holds its own grip, as heavy as the calibration found it. "
      "Nothing happens where it was not calibrated, or where the device does so by itself."));
  list();
  connect(device_, QOverload<int>::of(&QComboBox::currentIndexChanged), this,
          &DeviceRows::takeChange);
  connect(holds_grip_, &QCheckBox::toggled, this, &DeviceRows::changed);
}

void DeviceRows::addTo(QFormLayout* form) {
  addLabelled(form, tr("&Device"), device_, device_);
  form->addRow(tried_);
  form->addRow(heat_);
  form->addRow(QString(), holds_grip_);
}

void DeviceRows::list() {
  const QSignalBlocker blocker(device_);
  const QString chosen = device_->currentData().toString();
  device_->clear();
  for (const DeviceDriver& driver : deviceCatalog()) {
    for (const std::string& id : driver.scan()) {
      device_->addItem(QString::fromStdString(driver.make(id)->info().name),
                       QString::fromStdString(id));
    }
  }
  for (const PluginDevice& device : plugin_devices_) device_->addItem(device.name, device.id);
  if (!chosen.isEmpty()) choose(chosen);
}

void DeviceRows::setPluginDevices(std::vector<PluginDevice> devices) {
  plugin_devices_ = std::move(devices);
  list();
}

/// Plug-ins are asked when somebody wants to choose, and not before.
bool DeviceRows::eventFilter(QObject* watched, QEvent* event) {
  const bool turned_to =
      event->type() == QEvent::FocusIn || event->type() == QEvent::MouseButtonPress;
  if (watched == device_ && turned_to) Q_EMIT wanted();
  return QObject::eventFilter(watched, event);
}

/// What the catalogue of devices says of the chosen one.
void DeviceRows::showTried() {
  const auto tried = triedOnHardware(device_->currentData().toString().toStdString());
  QString text;
  if (!tried) {
    text = tr("Tried on hardware: ask who made the plug-in.");
  } else if (*tried == "never") {
    text = tr("Tried on hardware: never.");
  } else if (!tried->empty()) {
    text = tr("Tried on hardware: %1.").arg(QString::fromStdString(*tried));
  }
  setTextIfNew(tried_, text);
  tried_->setVisible(!text.isEmpty());
}

void DeviceRows::choose(const QString& id) {
  if (device_->findData(id) < 0) {
    QString name = id;
    try {
      name = QString::fromStdString(makeDevice(id.toStdString())->info().name);
    } catch (const Error&) {
      // Known to no driver: its id must do.
    }
    // Whether one of a plug-in, or a certain one of Haply's, is here, nobody has asked yet.
    const bool may_be_here =
        isPluginDevice(id.toStdString()) || id.startsWith(QLatin1String("haply:"));
    device_->addItem(may_be_here ? name : tr("%1 (not here now)").arg(name), id);
  }
  device_->setCurrentIndex(device_->findData(id));
  showTried();
}

std::string DeviceRows::device() const {
  return device_->currentData().toString().toStdString();
}

bool DeviceRows::holdsGrip() const {
  return holds_grip_->isChecked();
}

void DeviceRows::set(const std::string& device, bool holds_grip) {
  const QSignalBlocker a(device_), b(holds_grip_);
  holds_grip_->setChecked(holds_grip);
  choose(QString::fromStdString(device));
}

void DeviceRows::showHeat(const QString& heat) {
  setTextIfNew(heat_, heat);
  heat_->setVisible(!heat.isEmpty());
}

void DeviceRows::takeChange() {
  showTried();
  Q_EMIT changed();
}

}  // namespace relievo
