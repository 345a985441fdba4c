// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QWidget>
#include <vector>

#include "ui/work/device_trust.h"
#include "ui/work/work_queue.h"

class QCheckBox;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace relievo {

/// The plug-ins for devices that were found, each with a box that says whether it may run. Files
/// are read beside the window. [GUI thread]
class DeviceTrustBox : public QWidget {
  Q_OBJECT
 public:
  explicit DeviceTrustBox(DeviceTrust trust, QWidget* parent = nullptr);

  /// As at first: none of the user's own may run.
  void allowNone();

 Q_SIGNALS:
  void said(const QString& text);  ///< What was done, or why not.

 private:
  struct Row {
    QString file;
    QCheckBox* box;
    QLabel* note;
  };
  void look();
  void show(const std::vector<DevicePluginRow>& found);
  void addRow(const DevicePluginRow& found);
  void allow(const QString& name, const QString& file, bool allowed);

  DeviceTrust trust_;
  QVBoxLayout* column_;
  QLabel* none_;
  QPushButton* again_;
  std::vector<Row> rows_;
  WorkQueue work_;
};

}  // namespace relievo
