// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <QString>
#include <string>

class QFormLayout;
class QLabel;
class QPushButton;
class QWidget;

namespace relievo {

/// The row of the panel Touch that names the raster which says where the ground is firm.
/// [GUI thread]
class FirmnessRow : public QObject {
  Q_OBJECT
 public:
  /// @param panel  the dialog stands before it; owns this
  explicit FirmnessRow(QWidget* panel);
  void addTo(QFormLayout* form);

  /// A path, as in the settings; empty: none.
  const std::string& file() const { return file_; }
  void setFile(const std::string& file);
  /// Is it laid under the hand, or does it not fit the open map?
  void setUsed(bool used);

 Q_SIGNALS:
  void asked(const QString& file);  ///< Empty: none.

 private:
  void ask();
  void show();

  QWidget* panel_;
  QLabel* name_;
  QPushButton* choose_;
  QPushButton* none_;
  std::string file_;
  bool used_ = true;
};

}  // namespace relievo
