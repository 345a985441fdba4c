// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QDialog>

class QDialogButtonBox;
class QLabel;
class QLineEdit;

namespace relievo {

/// Asks for the address of a published map, in one line. What is none is said below the line while
/// it is typed, and cannot be opened. [GUI thread]
class AddressDialog : public QDialog {
  Q_OBJECT
 public:
  /// @param known  addresses that were opened before: offered while one is typed
  AddressDialog(const QString& begun, const QStringList& known, QWidget* parent);

 Q_SIGNALS:
  void chosen(const QString& address);

 private:
  QString address() const;
  void showMissing();

  QLineEdit* line_;
  QLabel* missing_;
  QDialogButtonBox* buttons_;
};

}  // namespace relievo
