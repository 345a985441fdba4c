// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QDialog>
#include <QStringList>

class QCheckBox;
class QLineEdit;
class QListWidget;
class QPushButton;

namespace relievo {

/// What goes into a package for citation; the same choices as `relievo project package`.
struct PackageChoice {
  QString file;
  bool with_input = true;
  QStringList recordings, figures;
};

/// Asks what a package for citation holds and where it goes. [GUI thread]
class PackageDialog : public QDialog {
  Q_OBJECT
 public:
  struct Offer {
    QString input;                    ///< The scan's path.
    QStringList recordings, figures;  ///< Ticked at first; missing files are left out.
    QString file;                     ///< Proposed name of the package.
  };
  PackageDialog(const Offer& offer, QWidget* parent);
  PackageChoice choice() const;

 private:
  void add(const QString& file);
  void ask();
  void browse();

  QCheckBox* with_input_;
  QListWidget* files_;
  QLineEdit* file_;
  QPushButton* save_;
};

}  // namespace relievo
