// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <QGroupBox>

#include "haptics/device/falcon/falcon_device.h"

class QLabel;
class QPlainTextEdit;
class QProgressBar;
class QPushButton;

namespace relievo {

class HomingPicture;

/// Read-only text of so many lines that the keyboard is never caught in.
QPlainTextEdit* textPage(const char* object_name, const QString& accessible, int lines);

/// Set-up of a Falcon: permission and firmware. [GUI thread]
class SetupStartBox : public QGroupBox {
  Q_OBJECT
 public:
  SetupStartBox();

  void showStatus(const falcon::LinkStatus& status);
  /// @param chosen  the file of the settings; empty: none was chosen
  void showFirmware(const std::string& chosen);
  QString firmwareText() const;

 Q_SIGNALS:
  void retryAsked();
  void browseAsked();
  void ruleCopied();

 private:
  QPushButton *retry_, *copy_rule_;
  QLabel* firmware_;
  QProgressBar* upload_;
  QPlainTextEdit* rule_;
};

/// Set-up of a Falcon: which arms have been found, and where the hand is. [GUI thread]
class SetupHomingBox : public QGroupBox {
  Q_OBJECT
 public:
  SetupHomingBox();

  void showStatus(const falcon::LinkStatus& status);

 private:
  HomingPicture* picture_;
  std::array<QLabel*, falcon::kArms> arms_{};
  QLabel* hand_;
};

}  // namespace relievo
