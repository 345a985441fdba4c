// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QDialog>
#include <QString>
#include <string>

namespace relievo {

/// An assistant that leads from plug to touch, for one kind of device, and holds the device while
/// it is open. [GUI thread]
class SetUpDialog : public QDialog {
  Q_OBJECT
 public:
  using QDialog::QDialog;

  /// Of the device that was set up, as makeDevice() takes it.
  virtual std::string deviceId() const = 0;
  /// The computer is about to sleep: nothing goes on at a force.
  virtual void endBeforeSleep() {}

 Q_SIGNALS:
  void said(const QString& text);  ///< For speech and status bar.
  void saved();                    ///< The device is to be used.
  void otherAsked();               ///< The assistant for another kind of device is wanted.
};

}  // namespace relievo
