// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QDialog>

#include "core/project/study.h"

class QCheckBox;
class QDialogButtonBox;
class QLabel;
class QLineEdit;
class QListWidget;
class QSpinBox;

namespace relievo {

/// Asks for a sitting of a study: who, with which consent, which places as conditions, how often
/// and in which folder. It says what is missing, and begins nothing before. [GUI thread]
class StudyDialog : public QDialog {
  Q_OBJECT
 public:
  /// @param places  names that can be conditions  @param folder  offered for sittings
  StudyDialog(const QStringList& places, const QString& folder, QWidget* parent);

  Study study() const;  ///< With seed 0.
  QString folder() const;

 Q_SIGNALS:
  void chosen(const relievo::Study& study, const QString& folder);

 private:
  QString missing() const;
  void showMissing();
  QStringList conditions() const;

  QLineEdit *participant_, *consent_, *folder_;
  QCheckBox* agreed_;
  QListWidget* places_;
  QSpinBox* repetitions_;
  QLabel* missing_;
  QDialogButtonBox* buttons_;
};

}  // namespace relievo
