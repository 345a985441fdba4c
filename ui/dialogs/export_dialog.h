// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QDialog>
#include <QString>

#include "core/session/export_map.h"

class QComboBox;
class QLabel;
class QLineEdit;

namespace relievo {

struct ExportOrder {
  MapExport choice;
  QString file;
};

/// Asks what goes to another program, in which format and where; says how large it will be.
/// [GUI thread]
class ExportDialog : public QDialog {
  Q_OBJECT
 public:
  /// @param model   names the file
  /// @param region  the window, with its level
  ExportDialog(std::shared_ptr<const Surface> surface, const Region& region, const QString& model,
               QWidget* parent);
  ExportOrder order() const;

 Q_SIGNALS:
  void chosen(const relievo::ExportOrder& order);

 private:
  void fillFormats();
  void fillParts();
  void fillCoordinates();
  void browse();
  QString ending() const;
  /// The file's ending follows the format, and the estimate all of them.
  void follow();

  std::shared_ptr<const Surface> surface_;
  Region region_;
  QComboBox *format_, *part_, *coordinates_;
  QLineEdit* file_;
  QLabel* size_;
};

}  // namespace relievo
