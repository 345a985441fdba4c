// SPDX-License-Identifier: BSD-3-Clause
#include "ui/dialogs/device_trust_box.h"

#include <algorithm>
#include <memory>
#include <QCheckBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <utility>

namespace relievo {

DeviceTrustBox::DeviceTrustBox(DeviceTrust trust, QWidget* parent)
    : QWidget(parent),
      trust_(std::move(trust)),
      column_(new QVBoxLayout(this)),
      none_(new QLabel(tr("They are being looked for."))),
      again_(new QPushButton(tr("&Look again"))) {
  column_->setContentsMargins(0, 0, 0, 0);
  none_->setObjectName(QStringLiteral("device_plugins_none"));
  none_->setWordWrap(true);
  none_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  again_->setObjectName(QStringLiteral("device_plugins_again"));
  again_->setAccessibleName(tr("Look for plug-ins again"));
  again_->setAutoDefault(false);
  column_->addWidget(none_);
  column_->addWidget(again_, 0, Qt::AlignLeft);
  setFocusProxy(again_);
  connect(again_, &QPushButton::clicked, this, &DeviceTrustBox::look);
  look();
}

void DeviceTrustBox::look() {
  const auto found = std::make_shared<std::vector<DevicePluginRow>>();
  work_.add([found, list = trust_.list](const Task&) { *found = list(); },
            [this, found] { show(*found); });
}

void DeviceTrustBox::show(const std::vector<DevicePluginRow>& found) {
  none_->setText(tr("None was found. Your own are looked for in %1.").arg(trust_.folder));
  none_->setVisible(found.empty());
  const bool same = std::equal(found.begin(), found.end(), rows_.begin(), rows_.end(),
                               [](const auto& a, const Row& b) { return a.file == b.file; });
  if (!same) {  // Else a box that has the focus keeps it.
    for (const Row& row : rows_) {
      delete row.box;
      delete row.note;
    }
    rows_.clear();
    for (const DevicePluginRow& plugin : found) addRow(plugin);
  }
  for (std::size_t i = 0; i < found.size(); ++i) {
    const QSignalBlocker blocker(rows_[i].box);
    rows_[i].box->setChecked(found[i].allowed);
    rows_[i].box->setEnabled(found[i].can_change);
    const bool by_place = found[i].allowed && !found[i].can_change;
    const QString note = by_place ? tr("Its folder is trusted.") : found[i].note;
    rows_[i].box->setAccessibleDescription(note);
    rows_[i].note->setText(note);
    rows_[i].note->setVisible(!note.isEmpty());
  }
}

void DeviceTrustBox::addRow(const DevicePluginRow& found) {
  const Row row{found.file, new QCheckBox(tr("%1 may run").arg(found.name)), new QLabel};
  row.box->setObjectName(QLatin1String("device_plugin_") + found.name);
  row.box->setAccessibleName(row.box->text());
  row.box->setToolTip(found.file);
  row.note->setWordWrap(true);
  row.note->setBuddy(row.box);
  const int place = 2 * static_cast<int>(rows_.size());
  column_->insertWidget(place, row.box);
  column_->insertWidget(place + 1, row.note);
  connect(row.box, &QCheckBox::toggled, this,
          [this, name = found.name, file = found.file](bool on) { allow(name, file, on); });
  rows_.push_back(row);
}

void DeviceTrustBox::allow(const QString& name, const QString& file, bool allowed) {
  const auto problem = std::make_shared<QString>();
  work_.add([file, allowed, problem,
             change = trust_.allow](const Task&) { *problem = change(file, allowed); },
            [this, name, allowed, problem] {
              const QString done = allowed ? tr("%1 may run from now on, until its file changes.")
                                           : tr("%1 may not run any more.");
              Q_EMIT said(problem->isEmpty() ? done.arg(name) : *problem);
              look();
            });
}

void DeviceTrustBox::allowNone() {
  for (const Row& row : rows_) {
    if (row.box->isEnabled()) row.box->setChecked(false);
  }
}

}  // namespace relievo
