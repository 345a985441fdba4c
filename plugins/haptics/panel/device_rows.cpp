// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/haptics/panel/device_rows.h"

#include <algorithm>
#include <map>
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

namespace {
/// What the catalogue of devices says of one; empty: nobody can feel it.
QString triedText(const QString& id) {
  const auto tried = triedOnHardware(id.toStdString());
  if (!tried) return DeviceRows::tr("Tried on hardware: ask who made the plug-in.");
  if (*tried == "never") return DeviceRows::tr("Tried on hardware: never.");
  if (tried->empty()) return {};
  return DeviceRows::tr("Tried on hardware: %1.").arg(QString::fromStdString(*tried));
}

bool isOfHaply(const QString& id) {
  return id == QLatin1String("haply") || id.startsWith(QLatin1String("haply:"));
}
}  // namespace

QStringList gripPositionTexts() {
  return {DeviceRows::tr("Before you, relief upright"), DeviceRows::tr("Before you, relief flat"),
          DeviceRows::tr("At your left, turned to you"),
          DeviceRows::tr("At your right, turned to you")};
}

DeviceRows::DeviceRows(QObject* parent) : QObject(parent) {
  device_ = relievo::choice("deviceList", tr("Device"), {});
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
  grip_ = relievo::choice("gripPosition", tr("How the device stands"), gripPositionTexts());
  grip_->setToolTip(
      tr("Which way the grip is pushed to press: away from you, or down onto a relief that lies "
         "flat; or the device stands beside you. Forces go off when it changes. The mouse is the "
         "same in each."));
  list();
  connect(grip_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &DeviceRows::changed);
  connect(device_, QOverload<int>::of(&QComboBox::currentIndexChanged), this,
          &DeviceRows::takeChange);
  connect(holds_grip_, &QCheckBox::toggled, this, &DeviceRows::changed);
}

void DeviceRows::addTo(QFormLayout* form) {
  addLabelled(form, tr("&Device"), device_, device_);
  form->addRow(tried_);
  form->addRow(heat_);
  form->addRow(QString(), holds_grip_);
  addLabelled(form, tr("Grip posi&tion"), grip_, grip_);
}

void DeviceRows::list() {
  const QSignalBlocker blocker(device_);
  const QString chosen = device_->currentData().toString();
  device_->clear();
  // Each by its name, once they are known; until then the only one.
  const bool names_haplys = std::any_of(plugin_devices_.begin(), plugin_devices_.end(),
                                        [](const PluginDevice& d) { return isOfHaply(d.id); });
  for (const DeviceDriver& driver : deviceCatalog()) {
    if (driver.kind == "haply" && !turned_to_) continue;  // To look is to try a connection.
    for (const std::string& id : driver.scan()) {
      const QString name = QString::fromStdString(driver.make(id)->info().name);
      if (id == "haply" && names_haplys && chosen != QLatin1String("haply")) continue;
      add(name, QString::fromStdString(id));
    }
  }
  for (const PluginDevice& device : plugin_devices_) add(device.name, device.id);
  tellApart();
  if (!chosen.isEmpty()) choose(chosen);
}

void DeviceRows::add(const QString& name, const QString& id) {
  device_->addItem(name, id);
  const int place = device_->count() - 1;
  const QString tried = triedText(id);
  device_->setItemData(place, tried, Qt::ToolTipRole);
  device_->setItemData(place, tried, Qt::AccessibleDescriptionRole);
}

/// Several with the same name have their ids, too.
void DeviceRows::tellApart() {
  std::map<QString, int> times;
  for (int i = 0; i < device_->count(); ++i) ++times[device_->itemText(i)];
  for (int i = 0; i < device_->count(); ++i) {
    const QString name = device_->itemText(i);
    if (times[name] == 1) continue;
    device_->setItemText(i, QStringLiteral("%1 (%2)").arg(name, device_->itemData(i).toString()));
  }
}

void DeviceRows::setPluginDevices(std::vector<PluginDevice> devices) {
  plugin_devices_ = std::move(devices);
  list();
}

/// Plug-ins and Haply's service are asked when somebody wants to choose, and not before.
bool DeviceRows::eventFilter(QObject* watched, QEvent* event) {
  const bool turns_to =
      event->type() == QEvent::FocusIn || event->type() == QEvent::MouseButtonPress;
  if (watched == device_ && turns_to) {
    if (!std::exchange(turned_to_, true)) list();
    Q_EMIT wanted();
  }
  return QObject::eventFilter(watched, event);
}

/// What the catalogue of devices says of the chosen one.
void DeviceRows::showTried() {
  const QString text = triedText(device_->currentData().toString());
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
    // Whether one of a plug-in, or of Haply's, is here, nobody has asked yet.
    const bool may_be_here = isPluginDevice(id.toStdString()) || isOfHaply(id);
    add(may_be_here ? name : tr("%1 (not here now)").arg(name), id);
  }
  device_->setCurrentIndex(device_->findData(id));
  showTried();
}

DeviceChoice DeviceRows::choice() const {
  return {.device = device_->currentData().toString().toStdString(),
          .holds_grip = holds_grip_->isChecked(),
          .grip = static_cast<GripPosition>(grip_->currentIndex())};
}

void DeviceRows::set(const DeviceChoice& choice) {
  const QSignalBlocker a(device_), b(holds_grip_), c(grip_);
  holds_grip_->setChecked(choice.holds_grip);
  grip_->setCurrentIndex(static_cast<int>(choice.grip));
  choose(QString::fromStdString(choice.device));
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
